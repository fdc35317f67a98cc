#include "morph/motion/easing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace morphkit::motion {
namespace {

constexpr int kSteps = 1000;

std::vector<Easing> rising_easings() {
  return {LinearEase{},
          SineEase{},
          SinusoidalEase{},
          SinusoidalEase{0, 1},
          SinusoidalEase{0, 0},
          SinusoidalEase{1, 1},
          SinusoidalEase{0.5, 0.5},
          SinusoidalEase{0.1, 0.95},
          ParabolicEase{},
          ParabolicEase{0, 1},
          ParabolicEase{0, 0},
          ParabolicEase{1, 1},
          ParabolicEase{0.5, 0.5},
          ParabolicEase{0.1, 0.95},
          CubicBezierEase{},
          CubicBezierEase{0, 0, 1, 1},
          CubicBezierEase{1, 0, 0, 1},
          CubicBezierEase{0, 1, 1, 0.5},
          StepEase{},
          StepEase{0},
          StepEase{1},
          KeysEase{{{0, 0, {}}, {0.2, 0.1, {}}, {0.6, 0.9, {}}, {1, 1, {}}}}};
}

TEST(Easing, EndsAreExactAndTimeIsClamped) {
  for (const Easing& easing : rising_easings()) {
    SCOPED_TRACE(easing.index());
    ASSERT_FALSE(problem(easing)) << *problem(easing);
    EXPECT_EQ(ease(easing, 0), 0);
    EXPECT_EQ(ease(easing, 1), 1);
    EXPECT_EQ(ease(easing, -5), 0);
    EXPECT_EQ(ease(easing, 7), 1);
    EXPECT_EQ(ease(easing, std::numeric_limits<double>::quiet_NaN()), 0);
  }
}

TEST(Easing, Rises) {
  // Neighbouring steps may differ by rounding, no more.
  constexpr double kRounding = 1e-15;
  for (const Easing& easing : rising_easings()) {
    SCOPED_TRACE(easing.index());
    for (int i = 1; i <= kSteps; ++i) {
      const double before = ease(easing, (i - 1.0) / kSteps), now = ease(easing, double(i) / kSteps);
      ASSERT_GE(now, before - kRounding) << "step " << i;
    }
  }
}

TEST(Easing, SymmetricEasingsAreSymmetric) {
  for (const Easing& easing : {Easing{LinearEase{}}, Easing{SineEase{}}, Easing{SinusoidalEase{0.2, 0.8}},
                               Easing{ParabolicEase{0.2, 0.8}}, Easing{CubicBezierEase{0.42, 0, 0.58, 1}}}) {
    SCOPED_TRACE(easing.index());
    for (int i = 0; i <= kSteps; ++i) {
      const double t = double(i) / kSteps;
      ASSERT_NEAR(ease(easing, t) + ease(easing, 1 - t), 1, 1e-14) << "t = " << t;
    }
  }
}

TEST(Easing, SineIsSlowAtTheEndsAndHalfwayInTheMiddle) {
  EXPECT_NEAR(ease(SineEase{}, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(ease(SineEase{}, 1.0 / 3), 0.25, 1e-15);
}

// Pieces must agree in value and slope where they meet.
void expect_smooth_at(const Easing& easing, double joint) {
  SCOPED_TRACE(joint);
  constexpr double h = 1e-6;
  const double before = ease(easing, joint - h), at = ease(easing, joint), after = ease(easing, joint + h);
  EXPECT_NEAR(before, at, 4 * h);
  EXPECT_NEAR(after, at, 4 * h);
  // The error of both one-sided slopes is at most h times the second derivative, here below 100.
  EXPECT_NEAR((at - before) / h, (after - at) / h, 200 * h);
}

TEST(Easing, SinusoidalAndParabolicPiecesMeetSmoothly) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.1, 0.9);
  for (int i = 0; i < 100; ++i) {
    double first = place(random), second = place(random);
    if (first > second) std::swap(first, second);
    SCOPED_TRACE(testing::Message() << "seed 7, pair " << first << ", " << second);
    if (second - first < 1e-3) continue;
    for (const Easing& easing : {Easing{SinusoidalEase{first, second}}, Easing{ParabolicEase{first, second}}}) {
      expect_smooth_at(easing, first);
      expect_smooth_at(easing, second);
    }
  }
}

TEST(Easing, MiddleOfSinusoidalAndParabolicRunsAtConstantSpeed) {
  // The speed of the straight piece: 1 / f of eq. 3.18, and v0.
  const double f = 2 * 0.3 / std::acos(-1) + 0.4 + 2 * 0.3 / std::acos(-1);
  for (double t = 0.3; t < 0.69; t += 0.05) {
    EXPECT_NEAR(ease(SinusoidalEase{0.3, 0.7}, t + 0.01) - ease(SinusoidalEase{0.3, 0.7}, t), 0.01 / f, 1e-14);
    EXPECT_NEAR(ease(ParabolicEase{0.3, 0.7}, t + 0.01) - ease(ParabolicEase{0.3, 0.7}, t), 0.01 * 2 / 1.4, 1e-14);
  }
}

TEST(Easing, WithoutEaseInAndOutTheyAreLinear) {
  for (int i = 0; i <= kSteps; ++i) {
    const double t = double(i) / kSteps;
    ASSERT_NEAR(ease(SinusoidalEase{0, 1}, t), t, 1e-15);
    ASSERT_NEAR(ease(ParabolicEase{0, 1}, t), t, 1e-15);
    ASSERT_NEAR(ease(CubicBezierEase{0.25, 0.25, 0.75, 0.75}, t), t, 1e-14);
  }
}

TEST(CubicBezierEase, NamedCurvesOfCss) {
  const CubicBezierEase ease_default, ease_in{0.42, 0, 1, 1}, ease_out{0, 0, 0.58, 1}, ease_in_out{0.42, 0, 0.58, 1};
  EXPECT_NEAR(ease(ease_default, 0.25), 0.4085105909, 1e-9);
  EXPECT_NEAR(ease(ease_default, 0.5), 0.8024033878, 1e-9);
  EXPECT_NEAR(ease(ease_in, 0.5), 0.3153568126, 1e-9);
  EXPECT_NEAR(ease(ease_out, 0.5), 0.6846431874, 1e-9);
  EXPECT_NEAR(ease(ease_in_out, 0.5), 0.5, 1e-15);
}

TEST(CubicBezierEase, LiesOnTheCurveForAnyHandles) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1), height(-2, 3);
  for (int i = 0; i < 500; ++i) {
    const double x1 = unit(random), y1 = height(random), x2 = unit(random), y2 = height(random), u = unit(random);
    SCOPED_TRACE(testing::Message() << "seed 11, round " << i << ", u = " << u);
    const double v = 1 - u, b1 = 3 * v * v * u, b2 = 3 * v * u * u, b3 = u * u * u;
    const double slope_x = 3 * (v * v * x1 + 2 * u * v * (x2 - x1) + u * u * (1 - x2));
    if (slope_x < 1e-3) continue;  // y may then change by any amount within the rounding of x
    EXPECT_NEAR(ease(CubicBezierEase{x1, y1, x2, y2}, b1 * x1 + b2 * x2 + b3), b1 * y1 + b2 * y2 + b3, 1e-10);
  }
}

TEST(CubicBezierEase, MayLeaveTheUnitInterval) {
  EXPECT_GT(ease(CubicBezierEase{0.3, 2, 0.6, 2}, 0.5), 1);
  EXPECT_LT(ease(CubicBezierEase{0.3, -2, 0.6, -2}, 0.3), 0);
}

TEST(StepEase, JumpsAtItsPlace) {
  EXPECT_EQ(ease(StepEase{0.25}, std::nextafter(0.25, 0)), 0);
  EXPECT_EQ(ease(StepEase{0.25}, 0.25), 1);
  EXPECT_EQ(ease(StepEase{0}, 1e-300), 1);
  EXPECT_EQ(ease(StepEase{1}, std::nextafter(1, 0)), 0);
}

TEST(Easing, ProblemsAreExplained) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem(SinusoidalEase{0.7, 0.3}), "k1, k2 must satisfy 0 <= k1 <= k2 <= 1");
  EXPECT_EQ(problem(ParabolicEase{-0.1, 0.3}), "t1, t2 must satisfy 0 <= t1 <= t2 <= 1");
  EXPECT_EQ(problem(CubicBezierEase{1.1, 0, 0, 0}), "x1 and x2 of a cubic Bezier must lie in [0, 1]");
  EXPECT_EQ(problem(StepEase{2}), "the place of a step must lie in [0, 1]");
  for (const Easing& easing :
       {Easing{SinusoidalEase{nan, 0.5}}, Easing{SinusoidalEase{0.5, nan}}, Easing{ParabolicEase{0.3, 1.1}},
        Easing{ParabolicEase{nan, nan}}, Easing{CubicBezierEase{nan, 0, 0, 0}}, Easing{CubicBezierEase{0, nan, 0, 0}},
        Easing{CubicBezierEase{0, 0, 0, std::numeric_limits<double>::infinity()}}, Easing{StepEase{nan}}}) {
    EXPECT_TRUE(problem(easing)) << easing.index();
  }
}

TEST(Timing, WithoutDelayItIsTheEasing) {
  for (const Easing& easing : rising_easings()) {
    for (double t : {0.0, 0.1, 0.5, 0.99, 1.0}) EXPECT_EQ(progress({easing, 0, 1}, t), ease(easing, t));
  }
}

TEST(Timing, WaitsRunsAndStays) {
  const Timing timing{LinearEase{}, 0.25, 0.5};
  EXPECT_EQ(progress(timing, 0.25), 0);
  EXPECT_DOUBLE_EQ(progress(timing, 0.375), 0.25);
  EXPECT_EQ(progress(timing, 0.75), 1);
  EXPECT_EQ(progress(timing, 0.9), 1);
}

TEST(Timing, EndsAreExactForEveryDelay) {
  for (int i = 0; i < kSteps; ++i) {
    const double delay = double(i) / kSteps, duration = double(kSteps - i) / kSteps;
    ASSERT_EQ(progress({SineEase{}, delay, duration}, 0), 0) << delay;
    ASSERT_EQ(progress({SineEase{}, delay, duration}, 1), 1) << delay;
    ASSERT_EQ(progress({SineEase{}, delay, 1 - delay}, 1), 1) << delay;
  }
}

TEST(Timing, NoDurationIsAJump) {
  const Timing timing{SineEase{}, 0.5, 0};
  EXPECT_EQ(progress(timing, std::nextafter(0.5, 0)), 0);
  EXPECT_EQ(progress(timing, 0.5), 1);
}

TEST(Timing, MayBeUnfinishedAtTheEnd) {
  EXPECT_DOUBLE_EQ(progress({LinearEase{}, 0.5, 1}, 1), 0.5);
}

}  // namespace
}  // namespace morphkit::motion
