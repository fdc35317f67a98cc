#include "morph/render/mesh_check.h"

#include <gtest/gtest.h>

#include "tests/support/errors.h"

namespace morphkit::render {
namespace {

using test::contains;

warp::Mesh even() {
  return warp::uniform_mesh(4, 3, {0, 0, 90, 60});
}

/// The vertex in column 2, row 1 lies left of its left neighbour.
warp::Mesh folded() {
  warp::Mesh mesh = even();
  mesh.at(2, 1).x = mesh.at(1, 1).x - 5;
  return mesh;
}

MeshSide side_of(const warp::Mesh& mesh) {
  return {mesh, mesh, mesh};
}

TEST(MeshCheck, AnEvenMeshDoesNotFold) {
  EXPECT_TRUE(mesh_folds({side_of(even()), side_of(even())}, even(), 0.5).empty());
}

TEST(MeshCheck, AFoldHasItsPictureItsVertexAndItsTime) {
  const std::vector<Finding> found = mesh_folds({side_of(even()), side_of(folded())}, folded(), 0.5);
  ASSERT_EQ(found.size(), 1u) << "a mesh that folds on a picture is not told again in between";
  EXPECT_EQ(found[0].kind, Finding::Kind::kMeshFold);
  EXPECT_EQ(found[0].where, "destination");
  EXPECT_EQ(found[0].t, 1);
  EXPECT_EQ(found[0].position, cv::Point2d(25, 30));
  EXPECT_EQ(found[0].vertices.front(), cv::Point(2, 1));
  EXPECT_TRUE(contains(found[0].message, "in the destination: the vertex in column 2, row 1")) << found[0].message;
}

TEST(MeshCheck, AMeshMayFoldInBetweenOnly) {
  const std::vector<Finding> found = mesh_folds({side_of(even()), side_of(even())}, folded(), 0.25);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where, kInBetween);
  EXPECT_EQ(found[0].t, 0.25);
}

TEST(MeshCheck, ABottleneckIsToldFromAVisibleLossOn) {
  MeshPasses passes;
  passes.t = 0.75;
  passes.area_lost = kVisibleLoss / 2;
  EXPECT_FALSE(bottleneck(kSource, passes));
  passes.area_lost = 0.5;
  const std::optional<Finding> loss = bottleneck(kSource, passes);
  ASSERT_TRUE(loss);
  EXPECT_EQ(loss->kind, Finding::Kind::kBottleneck);
  EXPECT_EQ(loss->t, 0.75);
  EXPECT_TRUE(contains(loss->message, "lacks 50 % of the area")) << loss->message;
  passes.folds = 1;
  EXPECT_TRUE(contains(bottleneck(kSource, passes)->message, "folds over at 1 vertex:"));
}

TEST(MeshCheck, TheNearestVertexOfAPosition) {
  EXPECT_EQ(nearest_vertex(even(), {-9, -9}), cv::Point(0, 0));
  EXPECT_EQ(nearest_vertex(even(), {46, 31}), cv::Point(2, 1));
  EXPECT_EQ(nearest_vertex(even(), {44, 61}), cv::Point(1, 2));
}

}  // namespace
}  // namespace morphkit::render
