#include "warp/mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace morphkit::warp {
namespace {

const cv::Rect2d kOutline(2, 3, 60, 40);

Mesh even() {
  return uniform_mesh(7, 5, kOutline);
}

TEST(Mesh, UniformLiesOnItsOutlineAtEvenSteps) {
  const Mesh mesh = uniform_mesh(4, 3, kOutline);
  ASSERT_EQ(mesh.vertices.size(), 12U);
  EXPECT_EQ(mesh.at(0, 0), cv::Point2d(2, 3));
  EXPECT_EQ(mesh.at(1, 0), cv::Point2d(22, 3));
  EXPECT_EQ(mesh.at(3, 1), cv::Point2d(62, 23));
  EXPECT_EQ(mesh.at(3, 2), cv::Point2d(62, 43));
  EXPECT_FALSE(off_outline(mesh, kOutline, 0));
}

TEST(Mesh, NamesTheFirstBorderVertexOffTheOutlineAndSnapsIt) {
  Mesh mesh = even();
  mesh.at(6, 2).x += 0.3;
  mesh.at(3, 4).y -= 0.6;
  mesh.at(3, 2) += cv::Point2d(5, 5);  // inside: free
  EXPECT_EQ(off_outline(mesh, kOutline, 0.5), (MeshVertex{3, 4}));
  EXPECT_EQ(off_outline(mesh, kOutline, 0.2), (MeshVertex{6, 2}));
  const cv::Point2d inner = mesh.at(3, 2);
  snap_to_outline(mesh, kOutline);
  EXPECT_FALSE(off_outline(mesh, kOutline, 0));
  EXPECT_EQ(mesh.at(3, 2), inner);
}

TEST(Mesh, TransposingTwiceChangesNothing) {
  const Mesh mesh = even();
  EXPECT_EQ(transposed(mesh).columns, mesh.rows);
  EXPECT_EQ(transposed(mesh).at(2, 3), cv::Point2d(mesh.at(3, 2).y, mesh.at(3, 2).x));
  EXPECT_EQ(transposed(transposed(mesh)), mesh);
}

struct FoldCase {
  const char* name;
  MeshVertex vertex;
  cv::Point2d shift;
  MeshFoldKind kind;
};

class MeshFolds : public testing::TestWithParam<FoldCase> {};

TEST_P(MeshFolds, AreNamedByVertexAndKind) {
  const FoldCase& fold = GetParam();
  Mesh mesh = even();
  ASSERT_TRUE(find_folds(mesh).empty());
  mesh.at(fold.vertex.column, fold.vertex.row) += fold.shift;
  const std::vector<MeshFold> folds = find_folds(mesh);
  EXPECT_TRUE(std::any_of(folds.begin(), folds.end(), [&](const MeshFold& found) {
    return found.vertex == fold.vertex && found.kind == fold.kind;
  }));
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshFolds,
                         testing::Values(FoldCase{"left", {3, 2}, {-10, 0}, MeshFoldKind::kLeftOfNeighbour},
                                         FoldCase{"above", {3, 2}, {0, -10}, MeshFoldKind::kAboveNeighbour},
                                         FoldCase{"right_curve", {3, 2}, {10.5, 0}, MeshFoldKind::kAcrossRightCurve},
                                         FoldCase{"lower_curve", {3, 2}, {0, 10.5}, MeshFoldKind::kAcrossLowerCurve}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(Mesh, FindsCurvesThatCrossBetweenVerticesInOrder) {
  // Every vertex is right of its left neighbour, but the second column's vertices stand so much lower that at the
  // height of (1, 1) the first column is already farther right.
  Mesh mesh = uniform_mesh(4, 4, {0, 0, 30, 30});
  mesh.at(1, 1) = {18, 9};
  mesh.at(2, 1) = {19, 19};
  mesh.at(2, 0) = {11, 0};
  mesh.at(1, 2) = {18.5, 20};
  mesh.at(2, 2) = {21, 24};
  const std::vector<MeshFold> folds = find_folds(mesh);
  ASSERT_FALSE(folds.empty());
  for (const MeshFold& fold : folds)
    EXPECT_TRUE(fold.kind == MeshFoldKind::kAcrossLeftCurve || fold.kind == MeshFoldKind::kAcrossRightCurve);
}

}  // namespace
}  // namespace morphkit::warp
