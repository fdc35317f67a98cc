#include "cli/edit/hand/mesh_tool.h"

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

TEST_F(GestureSession, MeshesAreMadeDraggedGrownAndShrunk) {
  key('5');
  click(project::kSource, {30, 30});
  ASSERT_TRUE(document().has_mesh());
  EXPECT_EQ(document().method(), project::MethodName::kMesh);
  const auto vertex = [&](SideIndex side, int i) {
    return document().mesh_vertices(side)[static_cast<std::size_t>(i)];
  };
  drag(project::kDestination, {200, 150}, {210, 140});
  EXPECT_EQ(vertex(project::kDestination, 12), cv::Point2d(210, 140));
  EXPECT_EQ(vertex(project::kSource, 12), cv::Point2d(200, 150));
  EXPECT_EQ(document().selection().vertices, Indices{12});
  type("c");  // the mouse is on the vertex, where there is no room: a little beside it
  EXPECT_EQ(document().project().mesh->columns, 6);
  move(project::kSource, {50, 37});
  type("r");
  EXPECT_EQ(document().project().mesh->rows, 6);
  EXPECT_NEAR(vertex(project::kSource, 6).y, 37, 1e-9);
  click(project::kSource, {100, 150});
  type(",.");
  EXPECT_EQ(document().project().mesh->columns, 5);
  EXPECT_EQ(document().project().mesh->rows, 6) << "the vertex has gone with its column";
  click(project::kSource, {0, 0});
  type(".");
  EXPECT_EQ(document().project().mesh->rows, 6) << "the border stays";
  EXPECT_EQ(steps_back(), 5);
}

TEST_F(GestureSession, VerticesThatABorderHeldBackComeBackUnderTheHand) {
  key('5');
  click(project::kSource, {30, 30});
  keys.shift = true;
  drag(project::kSource, {90, 140}, {210, 160});
  keys.shift = false;
  EXPECT_EQ(document().selection().vertices, (Indices{11, 12}));
  press(project::kSource, {100, 150});
  move(project::kSource, {-50, 150});
  EXPECT_EQ(document().mesh_vertices(project::kSource)[11], cv::Point2d(0, 150));
  move(project::kSource, {90, 150});
  EXPECT_EQ(document().mesh_vertices(project::kSource)[11], cv::Point2d(90, 150));
  EXPECT_EQ(document().mesh_vertices(project::kSource)[12], cv::Point2d(190, 150));
  release();
  EXPECT_EQ(steps_back(), 2);
}

TEST_F(GestureSession, MeshKeysWaitForTheMeshTool) {
  key('5');
  click(project::kSource, {30, 30});
  key('2');
  move(project::kSource, {50, 37});
  type("cr");
  EXPECT_EQ(document().project().mesh->columns, 5);
  EXPECT_EQ(document().project().mesh->rows, 5);
}

}  // namespace
}  // namespace morphkit::edit
