#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "morph/motion/arc_length.h"
#include "tests/unit/motion/random_curves.h"

namespace morphkit::motion {
namespace {

using test::kRandomCurves;
using test::random_curve;

double distance_to_chord(cv::Point2d p, cv::Point2d a, cv::Point2d b) {
  const cv::Point2d ab = b - a;
  const double square = ab.dot(ab);
  const double along = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0;
  const cv::Point2d foot = a + ab * along;
  return std::hypot(p.x - foot.x, p.y - foot.y);
}

// The largest distance of the curve from `n` equal chords, densely sampled.
double deviation(const Curve& curve, int n) {
  const auto points = equal_arc_points(curve, n);
  const ArcLength arc(curve);
  const int looks = std::max(64, 4000 / n);
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k <= looks; ++k) {
      const cv::Point2d p = curve.at(arc.parameter_at(arc.total() * (i + double(k) / looks) / n));
      worst = std::max(
          worst, distance_to_chord(p, points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(i) + 1]));
    }
  }
  return worst;
}

TEST(EqualArcPoints, AreEquallySpacedAlongTheCurve) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    const ArcLength arc(curve);
    for (int n : {1, 2, 7, 40}) {
      const auto points = equal_arc_points(curve, n);
      ASSERT_EQ(points.size(), static_cast<std::size_t>(n) + 1);
      EXPECT_EQ(points.front(), curve.at(0));
      EXPECT_EQ(points.back(), curve.at(curve.segments()));
      for (int i = 0; i <= n; ++i) {
        const cv::Point2d expected = curve.at(arc.parameter_at(arc.total() * i / n));
        const cv::Point2d got = points[static_cast<std::size_t>(i)];
        EXPECT_LT(std::hypot(got.x - expected.x, got.y - expected.y), 1e-9);
      }
    }
  }
}

TEST(EqualArcPoints, ChordsAreNoLongerThanTheirArcAndNearlyAsLongWhenFine) {
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    constexpr int n = 2000;
    const auto points = equal_arc_points(curve, n);
    const double arc = ArcLength(curve).total() / n;
    int shortened = 0;  // at corners and cusps only
    for (std::size_t i = 0; i < n; ++i) {
      const double chord = std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
      ASSERT_LE(chord, arc + 1e-6);
      if (chord < 0.98 * arc) ++shortened;
    }
    EXPECT_LE(shortened, 20);
  }
}

TEST(EqualArcPoints, ClosedCurvesEndWhereTheyBegin) {
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {30, 0}, {30, 30}, {0, 30}}, true);
  const auto points = equal_arc_points(curve, 8);
  EXPECT_EQ(points.front(), points.back());
  // A square's closed spline has its four-fold symmetry.
  EXPECT_LT(std::hypot(points[2].x - 30, points[2].y), 1e-9);
  EXPECT_LT(std::hypot(points[4].x - 30, points[4].y - 30), 1e-9);
}

TEST(ChordsNeeded, KeepsItsToleranceWithTheSmallestNumber) {
  constexpr int kLimit = 200;
  for (unsigned seed = 0; seed < kRandomCurves; ++seed) {
    const auto random = random_curve(seed);
    SCOPED_TRACE(random.name);
    const Curve curve = random.curve();
    for (double tolerance : {20.0, 2.0, 0.5}) {
      const int n = chords_needed(curve, tolerance, kLimit);
      ASSERT_GE(n, random.closed ? 3 : 1);
      ASSERT_LE(n, kLimit);
      if (n == kLimit) continue;
      EXPECT_LE(deviation(curve, n), tolerance) << n << " chords";
      // 63/64: the samples of chords_needed reach this part of an arc's height.
      if (n <= 3) continue;
      EXPECT_GT(deviation(curve, n - 1), tolerance * 63 / 64) << n - 1 << " chords would be enough";
    }
  }
}

TEST(ChordsNeeded, OneForAStraightLineWithAnyParameter) {
  EXPECT_EQ(chords_needed(Curve(CurveKind::kPolyline, {{0, 0}, {500, 100}}, false), 0.1, 64), 1);
  EXPECT_EQ(chords_needed(Curve(CurveKind::kCatmullRom, {{0, 0}, {1, 1}, {50, 50}}, false), 0.1, 64), 1);
}

TEST(ChordsNeeded, ChordsMeetCornersAtEqualLengths) {
  EXPECT_EQ(chords_needed(Curve(CurveKind::kPolyline, {{0, 0}, {100, 0}, {100, 100}, {200, 100}}, false), 0.1, 64), 3);
}

TEST(ChordsNeeded, GivesTheLimitWhenNothingIsFineEnough) {
  const Curve curve(CurveKind::kCatmullRom, {{0, 0}, {100, 200}, {200, 0}, {300, 200}}, false);
  EXPECT_EQ(chords_needed(curve, 1e-6, 16), 16);
  EXPECT_EQ(chords_needed(curve, 1e-6, 1), 1);
}

TEST(ChordsNeeded, FallsOffWithTheSquareRootOfTheTolerance) {
  const Curve arc(CurveKind::kBezier, {{0, 0}, {0, 55.2}, {44.8, 100}, {100, 100}}, false);
  const int coarse = chords_needed(arc, 0.4, 500), fine = chords_needed(arc, 0.1, 500);
  EXPECT_NEAR(static_cast<double>(fine) / coarse, 2, 0.35);
}

}  // namespace
}  // namespace morphkit::motion
