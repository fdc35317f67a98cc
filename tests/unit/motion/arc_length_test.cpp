#include "morph/motion/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/motion/random_curves.h"

namespace morphkit::motion {
namespace {

using test::kRandomCurves;
using test::random_curve;

// The length of a chain of very many chords: slow, a lower bound, and independent of any integration rule. Its error
// falls with the square of the step; Richardson extrapolation removes that term where the curve is smooth.
double chain_length(const Curve& curve, double from, double to, int chords) {
  double sum = 0;
  cv::Point2d last = curve.at(from);
  for (int i = 1; i <= chords; ++i) {
    const cv::Point2d next = curve.at(from + (to - from) * i / chords);
    sum += std::hypot(next.x - last.x, next.y - last.y);
    last = next;
  }
  return sum;
}

double reference_length(const Curve& curve, double from, double to) {
  const double coarse = chain_length(curve, from, to, 20000), fine = chain_length(curve, from, to, 40000);
  return fine + (fine - coarse) / 3;
}

TEST(ArcLength, OfALineIsItsLength) {
  const Curve line(CurveKind::kPolyline, {{1, 1}, {4, 5}}, false);
  const ArcLength arc(line);
  EXPECT_NEAR(arc.total(), 5, 1e-14);
  EXPECT_NEAR(arc.length_at(0.3), 1.5, 1e-14);
  EXPECT_NEAR(arc.parameter_at(2), 0.4, 1e-14);
}

TEST(ArcLength, OfUnevenHandlesOnALineIsStillItsLength) {
  const ArcLength arc(Curve(CurveKind::kBezier, {{0, 0}, {0, 0}, {300, 0}, {300, 0}}, false));
  EXPECT_NEAR(arc.total(), 300, 1e-10);
  // x(u) = 300 (3u^2 - 2u^3), and the speed is 0 at both ends.
  for (double u : {1e-4, 0.1, 0.5, 0.8, 0.9999}) EXPECT_NEAR(arc.length_at(u), 300 * u * u * (3 - 2 * u), 1e-9);
  for (double s : {1e-9, 1e-3, 10.0, 150.0, 299.0, 299.999999})
    EXPECT_NEAR(arc.length_at(arc.parameter_at(s)), s, 1e-9);
}

TEST(ArcLength, OfTheBezierCircleIsNearlyTwoPiR) {
  // With handles of length k R, k = 4 (sqrt(2) - 1) / 3, the error of the radius is at most 2.73e-4 R, always outwards.
  const double r = 100, k = 4 * (std::sqrt(2.0) - 1) / 3 * r;
  const Curve circle(
      CurveKind::kBezier,
      {{r, 0}, {r, k}, {k, r}, {0, r}, {-k, r}, {-r, k}, {-r, 0}, {-r, -k}, {-k, -r}, {0, -r}, {k, -r}, {r, -k}}, true);
  const double round = 2 * std::acos(-1) * r;
  const ArcLength arc(circle);
  EXPECT_GT(arc.total(), round);
  EXPECT_LT(arc.total(), round * (1 + 2.73e-4));
  EXPECT_NEAR(arc.length_at(1), arc.total() / 4, 1e-9);
}

TEST(ArcLength, OfACuspIsExact) {
  // The handles cross so that Q'(1/2) = 0; both halves are mirror images.
  const Curve cusp(CurveKind::kBezier, {{0, 0}, {100, 100}, {0, 100}, {100, 0}}, false);
  EXPECT_LT(std::hypot(cusp.derivative(0.5).x, cusp.derivative(0.5).y), 1e-12);
  const ArcLength arc(cusp);
  EXPECT_NEAR(arc.total(), reference_length(cusp, 0, 0.5) + reference_length(cusp, 0.5, 1), 1e-6);
  EXPECT_NEAR(arc.length_at(0.5), arc.total() / 2, 1e-6);
  for (int i = 0; i <= 200; ++i) {
    const double s = arc.total() * i / 200;
    ASSERT_NEAR(arc.length_at(arc.parameter_at(s)), s, 1e-9) << i;
  }
}

TEST(ArcLength, AgreesWithManyChords) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    const ArcLength arc(curve);
    double expected = 0;
    for (int i = 0; i < curve.segments(); ++i) {
      expected += reference_length(curve, i, i + 1);
      EXPECT_NEAR(arc.length_at(i + 1), expected, 2e-6);
    }
    EXPECT_NEAR(arc.total(), expected, 2e-6);
    EXPECT_EQ(arc.length_at(curve.segments()), arc.total());
    EXPECT_EQ(arc.length_at(0), 0);
  }
}

TEST(ArcLength, RoundTripsAndRises) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const ArcLength arc(random.curve());
    double last = 0;
    for (int i = 0; i <= 500; ++i) {
      const double s = arc.total() * i / 500, u = arc.parameter_at(s);
      ASSERT_GE(u, last) << i;
      ASSERT_NEAR(arc.length_at(u), s, 1e-9) << i;
      last = u;
    }
  }
}

TEST(ArcLength, HoldsItsToleranceAsAsked) {
  const Curve curve(CurveKind::kBezier, {{0, 0}, {400, 10}, {-300, 20}, {100, 200}}, false);
  const double exact = ArcLength(curve, 1e-12).total();
  for (double tolerance : {1.0, 1e-3, 1e-6}) EXPECT_NEAR(ArcLength(curve, tolerance).total(), exact, tolerance);
}

TEST(ArcLength, PassesOverSegmentsWithoutLength) {
  const Curve curve(CurveKind::kPolyline, {{0, 0}, {0, 0}, {3, 0}, {3, 0}, {3, 4}, {3, 4}}, false);
  const ArcLength arc(curve);
  EXPECT_NEAR(arc.total(), 7, 1e-13);
  for (int i = 0; i <= 70; ++i) EXPECT_NEAR(arc.length_at(arc.parameter_at(i / 10.0)), i / 10.0, 1e-12) << i;
}

TEST(ArcLength, ClampsBeyondItsEnds) {
  const ArcLength arc(Curve(CurveKind::kPolyline, {{0, 0}, {3, 0}, {3, 4}}, false));
  EXPECT_EQ(arc.length_at(-1), 0);
  EXPECT_EQ(arc.length_at(5), arc.total());
  EXPECT_EQ(arc.parameter_at(-1), 0);
  EXPECT_EQ(arc.parameter_at(8), 2);
}

TEST(ArcLength, TinyAndHugeCurvesEndAndAreAccurate) {
  for (double scale : {1e-9, 1e-3, 1e6, 1e11}) {
    SCOPED_TRACE(scale);
    const Curve curve(CurveKind::kBezier, {{0, 0}, {scale, scale}, {0, scale}, {scale, 0}}, false);
    const ArcLength arc(curve);
    const double expected = reference_length(curve, 0, 0.5) + reference_length(curve, 0.5, 1);
    EXPECT_NEAR(arc.total() / expected, 1, 1e-6);
    EXPECT_LT(arc.table().size(), 2000u);
  }
}

}  // namespace
}  // namespace morphkit::motion
