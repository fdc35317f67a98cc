// The curves of a mesh pass through their knots and stay between them.

#include "warp/mesh/mesh_curves.h"

#include <vector>

#include <gtest/gtest.h>

namespace morphkit::warp {
namespace {

constexpr MeshSpline kSplines[] = {MeshSpline::kMonotone, MeshSpline::kCatmullRom, MeshSpline::kLinear};

TEST(CurveFamily, PassesThroughItsKnots) {
  const std::vector<double> along = {0, 4, 10, 0, 5, 10}, across = {1, 3, 2, 7, 8, 9};
  for (const MeshSpline spline : kSplines) {
    const CurveFamily family(spline, 3, along, across);
    ASSERT_EQ(family.curves(), 2U);
    CurveFamily::Hints hints(2, kUnknown);
    for (std::size_t i = 0; i < along.size(); ++i) {
      EXPECT_NEAR(family.intercept(i / 3, along[i], hints), across[i], 1e-12) << i;
    }
    std::vector<double> both(2);
    family.intercepts(5, hints, both);
    EXPECT_NEAR(both[1], 8, 1e-12);
    EXPECT_LT(both[0], both[1]);
  }
}

TEST(LineKnots, LeadFromKnotToKnotAndNoFurther) {
  for (const MeshSpline spline : kSplines) {
    LineKnots knots;
    knots.resize(4);
    knots.to = {2, 5, 6, 20};
    knots.from = {-3, 4, 9, 30};
    knots.prepare(spline, 25);
    std::size_t segment = kUnknown;
    EXPECT_EQ(knots.at(0, segment), 0);  // -3 is clamped
    EXPECT_NEAR(knots.at(5, segment), 4, 1e-12);
    EXPECT_NEAR(knots.at(6, segment), 9, 1e-12);
    EXPECT_EQ(knots.at(100, segment), 25);
  }
}

TEST(LineKnots, AMonotoneSplineStandsStillWhereItsKnotsDo) {
  LineKnots knots;
  knots.resize(4);
  knots.to = {0, 10, 20, 30};
  knots.from = {0, 15, 15, 30};
  knots.prepare(MeshSpline::kMonotone, 30);
  std::size_t segment = kUnknown;
  for (double x = 10; x <= 20; x += 0.5) EXPECT_NEAR(knots.at(x, segment), 15, 1e-12);
}

}  // namespace
}  // namespace morphkit::warp
