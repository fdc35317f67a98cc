#include "morph/motion/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/unit/motion/random_curves.h"

namespace morphkit::motion {
namespace {

using Points = std::vector<cv::Point2d>;
using test::kRandomCurves;
using test::random_curve;

double distance(cv::Point2d a, cv::Point2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(Curve, PassesThroughItsPointsExactly) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    const std::size_t stride = random.kind == CurveKind::kBezier ? 3 : 1;
    for (int i = 0; i <= curve.segments(); ++i) {
      EXPECT_EQ(curve.at(i), random.points[static_cast<std::size_t>(i) * stride % random.points.size()]) << i;
    }
  }
}

TEST(Curve, IsContinuousAndItsDerivativeIsTheLimitOfDifferences) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    for (int i = 1; i < curve.segments(); ++i) EXPECT_LT(distance(curve.at(i - 1e-9), curve.at(i)), 1e-5);
    for (double u = 0.05; u < curve.segments(); u += 0.1) {
      constexpr double h = 1e-5;
      EXPECT_LT(distance((curve.at(u + h) - curve.at(u - h)) / (2 * h), curve.derivative(u)), 1e-5) << u;
    }
  }
}

TEST(Curve, ClampsItsParameter) {
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {10, 5}, {20, 0}}, false);
  EXPECT_EQ(curve.at(-3), curve.at(0));
  EXPECT_EQ(curve.at(99), curve.at(2));
  EXPECT_EQ(curve.at(std::numeric_limits<double>::quiet_NaN()), curve.at(0));
}

TEST(Curve, PolylineMovesEvenlyOnItsLines) {
  const Curve curve(CurveKind::kPolyline, {{0, 0}, {9, 3}, {9, 30}}, false);
  for (int i = 0; i <= 10; ++i) {
    EXPECT_LT(distance(curve.at(i / 10.0), {9 * i / 10.0, 3 * i / 10.0}), 1e-13);
    EXPECT_LT(distance(curve.at(1 + i / 10.0), {9, 3 + 27 * i / 10.0}), 1e-13);
  }
}

TEST(Curve, CatmullRomOnEvenKeysIsTheClassicOne) {
  // Neighbours at equal distance: tangents are half the chord between them.
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {3, 4}, {8, 4}, {11, 8}}, false);
  EXPECT_LT(distance(curve.derivative(1), {4, 2}), 1e-14);
  EXPECT_LT(distance(curve.derivative(2), {4, 2}), 1e-14);
  EXPECT_LT(distance(curve.derivative(0), {3, 4}), 1e-14) << "the reflected neighbour makes the first chord";
}

TEST(Curve, CatmullRomTangentsFitTheirOwnSegmentAtUnevenKeys) {
  // Chords of length 1 and 9 on both sides of (1, 0): tangent (5, 0), scaled by 2 * 1 / 10 and by 2 * 9 / 10.
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {1, 0}, {10, 0}}, false);
  EXPECT_LT(distance(curve.derivative(std::nextafter(1, 0)), {1, 0}), 1e-12);
  EXPECT_LT(distance(curve.derivative(1), {9, 0}), 1e-12);
}

TEST(Curve, CatmullRomOnALineNeverDoublesBack) {
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {1, 0}, {100, 0}, {100.5, 0}, {400, 0}}, false);
  for (double u = 0; u < 4; u += 0.001) ASSERT_GT(curve.derivative(u).x, 0) << u;
}

TEST(Curve, CatmullRomJointsKeepTheirDirection) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    if (random.kind != CurveKind::kCatmullRom) continue;
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    for (int i = random.closed ? 0 : 1; i < curve.segments(); ++i) {
      const double joint = i == 0 ? curve.segments() : i;
      const cv::Point2d before = curve.derivative(joint - 1e-9), after = curve.derivative(i);
      EXPECT_NEAR(before.dot(after) / (distance(before, {}) * distance(after, {})), 1, 1e-6) << i;
    }
  }
}

TEST(Curve, ClosedCatmullRomDoesNotDependOnItsStart) {
  const Points points = {{0, 0}, {30, -5}, {50, 40}, {10, 60}}, turned = {{30, -5}, {50, 40}, {10, 60}, {0, 0}};
  const Curve a(CurveKind::kCatmullRom, points, true), b(CurveKind::kCatmullRom, turned, true);
  for (double u = 0; u < 3; u += 0.05) EXPECT_LT(distance(a.at(u + 1), b.at(u)), 1e-12);
  for (double u = 0; u < 1; u += 0.05) EXPECT_LT(distance(a.at(u), b.at(u + 3)), 1e-12);
}

TEST(Curve, RepeatedPointsAreASegmentWithoutLength) {
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {5, 5}, {5, 5}, {5, 5}, {9, 5}}, false);
  for (double u = 1; u <= 3; u += 0.25) EXPECT_EQ(curve.at(u), cv::Point2d(5, 5)) << u;
}

TEST(Curve, ProblemsAreExplained) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto why = [](CurveKind kind, const Points& points, bool closed) {
    return Curve::problem(kind, points, closed).value_or("");
  };
  const Points two = {{0, 0}, {1, 1}}, three = {{0, 0}, {1, 1}, {2, 0}}, four = {{0, 0}, {1, 1}, {2, 0}, {3, 3}};
  EXPECT_EQ(why(CurveKind::kPolyline, {{0, 0}}, false), "an open curve needs at least 2 points, but has 1");
  EXPECT_EQ(why(CurveKind::kCatmullRom, two, true), "a closed curve needs at least 3 points, but has 2");
  EXPECT_EQ(why(CurveKind::kBezier, three, false),
            "an open Bezier curve needs 3n + 1 points (4, 7, 10, ...), but has 3");
  EXPECT_EQ(why(CurveKind::kBezier, four, true), "a closed Bezier curve needs 3n points (3, 6, 9, ...), but has 4");
  EXPECT_EQ(why(CurveKind::kBezier, {}, true), "a closed Bezier curve needs 3n points (3, 6, 9, ...), but has 0");
  EXPECT_EQ(why(CurveKind::kPolyline, {{0, 0}, {1, nan}}, false),
            "point 1 of the curve must have two finite coordinates");
  EXPECT_EQ(why(CurveKind::kPolyline, {{1e300, 0}, {1, 1}}, false),
            "point 0 of the curve must lie within 1e12 of the origin");
  EXPECT_EQ(why(CurveKind::kPolyline, {{4, 4}, {4, 4}}, false),
            "all points of the curve coincide; at least two must differ");
  EXPECT_EQ(why(CurveKind::kBezier, four, false), "");
  EXPECT_EQ(why(CurveKind::kBezier, three, true), "");
  EXPECT_THROW(Curve(CurveKind::kPolyline, {{4, 4}, {4, 4}}, false), std::invalid_argument);
}

}  // namespace
}  // namespace morphkit::motion
