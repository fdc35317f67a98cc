#include "warp/analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace morphkit::warp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A map from a function of the output pixel's centre.
Map make_map(cv::Size size, const std::function<cv::Point2d(cv::Point2d)>& source_from_output) {
  Map map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point2d position = source_from_output({x + 0.5, y + 0.5});
      map(y, x) = {static_cast<float>(position.x), static_cast<float>(position.y)};
    }
  }
  return map;
}

Map identity(cv::Size size) {
  return make_map(size, [](cv::Point2d p) { return p; });
}

/// An affine map with coefficients that are multiples of 1/8: every position is exact in float.
struct Affine {
  double xx, xy, yx, yy, tx, ty;
  cv::Point2d operator()(cv::Point2d p) const { return {xx * p.x + xy * p.y + tx, yx * p.x + yy * p.y + ty}; }
  double determinant() const { return xx * yy - xy * yx; }
};

Affine random_affine(std::mt19937& random) {
  std::uniform_int_distribution<int> eighths(-24, 24);
  const auto next = [&] { return eighths(random) / 8.0; };
  return {next(), next(), next(), next(), next(), next()};
}

class AnalysisOfSize : public testing::TestWithParam<cv::Size> {};

TEST_P(AnalysisOfSize, IdentityNeitherTurnsNorStretches) {
  const Map map = identity(GetParam());
  const cv::Mat1f determinant = jacobian_determinant(map);
  const cv::Mat2f values = stretch(map);
  ASSERT_EQ(determinant.size(), map.size());
  ASSERT_EQ(values.size(), map.size());
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      ASSERT_EQ(determinant(y, x), 1.0F);
      ASSERT_EQ(values(y, x), cv::Vec2f(1, 1));
    }
  }
  EXPECT_TRUE(find_folds(map).empty());
  EXPECT_EQ(stretch_range(map).smallest, 1);
  EXPECT_EQ(stretch_range(map).largest, 1);
}

INSTANTIATE_TEST_SUITE_P(Sizes, AnalysisOfSize,
                         testing::Values(cv::Size(1, 1), cv::Size(1, 9), cv::Size(9, 1), cv::Size(2, 2),
                                         cv::Size(67, 41)));

TEST(Analysis, AffineMapsAreExact) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int round = 0; round < 100; ++round) {
    const Affine affine = random_affine(random);
    const Map map = make_map({7, 5}, affine);
    const cv::Mat1f determinant = jacobian_determinant(map);
    const cv::Mat2f values = stretch(map);
    // The singular values by an independent route: roots of the eigenvalues of J^T J.
    const double trace = affine.xx * affine.xx + affine.xy * affine.xy + affine.yx * affine.yx + affine.yy * affine.yy;
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        ASSERT_EQ(determinant(y, x), static_cast<float>(affine.determinant()));
        const cv::Vec2f s = values(y, x);
        ASSERT_GE(s[0], s[1]);
        ASSERT_GE(s[1], 0);
        ASSERT_NEAR(s[0] * s[1], std::abs(affine.determinant()), 1e-5);
        ASSERT_NEAR(s[0] * s[0] + s[1] * s[1], trace, 1e-5);
      }
    }
    const std::vector<FoldRegion> folds = find_folds(map);
    EXPECT_EQ(folds.size(), affine.determinant() <= 0 ? 1U : 0U);
  }
}

TEST(Analysis, RotationKeepsLengths) {
  const double angle_rad = std::numbers::pi / 7;
  const Map map = make_map({32, 32}, [&](cv::Point2d p) {
    return cv::Point2d(std::cos(angle_rad) * p.x - std::sin(angle_rad) * p.y,
                       std::sin(angle_rad) * p.x + std::cos(angle_rad) * p.y);
  });
  const StretchRange range = stretch_range(map);
  // Positions up to 64 are rounded to 2^-18; half a difference of two.
  EXPECT_NEAR(range.smallest, 1, 8e-6);
  EXPECT_NEAR(range.largest, 1, 8e-6);
}

TEST(Analysis, StretchIsAboveOneForMinificationAndBelowForMagnification) {
  const Map map = make_map({16, 16}, [](cv::Point2d p) { return cv::Point2d(4 * p.x, 0.25 * p.y); });
  EXPECT_EQ(stretch_range(map).largest, 4);
  EXPECT_EQ(stretch_range(map).smallest, 0.25);
}

TEST(Analysis, MirroredMapFoldsEverywhere) {
  const cv::Size size(40, 30);
  const std::vector<FoldRegion> folds =
      find_folds(make_map(size, [&](cv::Point2d p) { return cv::Point2d(size.width - p.x, p.y); }));
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_EQ(folds[0].area_px, 40 * 30);
  EXPECT_EQ(folds[0].bounds, cv::Rect({0, 0}, size));
  EXPECT_EQ(folds[0].centroid, cv::Point2d(20, 15));
}

TEST(Analysis, ConstantMapFoldsEverywhere) {
  const std::vector<FoldRegion> folds = find_folds(make_map({8, 8}, [](cv::Point2d) { return cv::Point2d(3, 3); }));
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_EQ(folds[0].area_px, 64);
}

/// The identity, except that x runs backwards twice as fast inside `box`.
void fold(Map& map, const cv::Rect& box) {
  const double middle = box.x + box.width / 2.0;
  for (int y = box.y; y < box.br().y; ++y) {
    for (int x = box.x; x < box.br().x; ++x) map(y, x)[0] = static_cast<float>(middle - 2 * (x + 0.5 - middle));
  }
}

TEST(Analysis, FindsALocalFoldInItsPlace) {
  Map map = identity({60, 50});
  const cv::Rect box(20, 15, 10, 8);
  fold(map, box);
  // Row by row: x of the map runs ..., 18.5, 19.5 | 34, 32, ..., 16 | 30.5, 31.5, ...: the central differences are
  // positive at the first and the last pixel of the box and at its outer neighbours, and -2 inside. In y, rows above
  // and below differ in x only, which leaves det = dx/dx * 1.
  const std::vector<FoldRegion> folds = find_folds(map);
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_EQ(folds[0].area_px, 8 * 8);
  EXPECT_EQ(folds[0].bounds, cv::Rect(21, 15, 8, 8));
  EXPECT_EQ(folds[0].centroid, cv::Point2d(25, 19));
}

TEST(Analysis, FoldsAreSortedLargestFirstThenByPosition) {
  Map map = identity({100, 80});
  const cv::Rect small_low(60, 60, 6, 4);
  const cv::Rect small_high(70, 10, 6, 4);
  const cv::Rect large(20, 40, 20, 10);
  fold(map, small_low);
  fold(map, small_high);
  fold(map, large);
  const std::vector<FoldRegion> folds = find_folds(map);
  ASSERT_EQ(folds.size(), 3U);
  EXPECT_EQ(folds[0].bounds, cv::Rect(21, 40, 18, 10));
  EXPECT_EQ(folds[1].bounds, cv::Rect(71, 10, 4, 4));
  EXPECT_EQ(folds[2].bounds, cv::Rect(61, 60, 4, 4));
}

TEST(Analysis, RegionsTouchingAtACornerAreOne) {
  Map map = identity({40, 40});
  fold(map, {10, 10, 6, 4});
  fold(map, {14, 14, 6, 4});
  // Folded are columns 11..14 of the first and 15..18 of the second: pixels (14, 13) and (15, 14) touch.
  const std::vector<FoldRegion> folds = find_folds(map);
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_EQ(folds[0].bounds, cv::Rect(11, 10, 8, 8));
  EXPECT_EQ(folds[0].area_px, 32);
}

TEST(Analysis, NonFinitePixelsAndTheirNeighboursAreNotFolds) {
  for (const float hole : {kNan, std::numeric_limits<float>::infinity()}) {
    Map map = make_map({9, 9}, [](cv::Point2d p) { return cv::Point2d(2 * p.x, p.y); });
    map(4, 4) = {hole, 1};
    const cv::Mat1f determinant = jacobian_determinant(map);
    const cv::Mat2f values = stretch(map);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const bool touches = std::abs(x - 4) + std::abs(y - 4) <= 1;
        EXPECT_EQ(std::isnan(determinant(y, x)), touches) << x << ", " << y;
        EXPECT_EQ(std::isnan(values(y, x)[0]), touches) << x << ", " << y;
        EXPECT_EQ(std::isnan(values(y, x)[1]), touches) << x << ", " << y;
      }
    }
    EXPECT_TRUE(find_folds(map).empty());
    EXPECT_EQ(stretch_range(map).smallest, 1);
    EXPECT_EQ(stretch_range(map).largest, 2);
  }
}

TEST(Analysis, MapWithoutFinitePixels) {
  const Map map(5, 5, MapPoint(kNan, kNan));
  EXPECT_TRUE(find_folds(map).empty());
  EXPECT_EQ(stretch_range(map).smallest, 1);
  EXPECT_EQ(stretch_range(map).largest, 1);
}

TEST(Analysis, EmptyMap) {
  EXPECT_TRUE(jacobian_determinant(Map()).empty());
  EXPECT_TRUE(stretch(Map()).empty());
  EXPECT_TRUE(find_folds(Map()).empty());
  EXPECT_EQ(stretch_range(Map()).largest, 1);
}

}  // namespace
}  // namespace morphkit::warp
