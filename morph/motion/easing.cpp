#include "morph/motion/easing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "morph/motion/monotone_keys.h"

namespace morphkit::motion {
namespace {

constexpr double kPi = std::numbers::pi;

bool in_unit(double x) {
  return x >= 0 && x <= 1;
}

std::optional<std::string> breaks_problem(double first, double second, const std::string& a, const std::string& b) {
  if (0 <= first && first <= second && second <= 1) return std::nullopt;
  return a + ", " + b + " must satisfy 0 <= " + a + " <= " + b + " <= 1";
}

// One overload of `invalid` and of `shape` per easing. `shape` is called with t strictly inside (0, 1), so divisions by
// the width of a piece are safe: t never lies in a piece of width 0.

std::optional<std::string> invalid(const LinearEase&) {
  return std::nullopt;
}
double shape(const LinearEase&, double t) {
  return t;
}

std::optional<std::string> invalid(const SineEase&) {
  return std::nullopt;
}
double shape(const SineEase&, double t) {
  return (std::sin(kPi * t - kPi / 2) + 1) / 2;
}

std::optional<std::string> invalid(const SinusoidalEase& e) {
  return breaks_problem(e.k1, e.k2, "k1", "k2");
}

// Parent, eq. 3.18. The quarter sines have slope 1 where they meet the straight piece; f scales the whole to end at 1.
double shape(const SinusoidalEase& e, double t) {
  const double ease_in = 2 * e.k1 / kPi, straight = e.k2 - e.k1, ease_out = 2 * (1 - e.k2) / kPi;
  const double f = ease_in + straight + ease_out;
  if (t < e.k1) return ease_in * (std::sin((t / e.k1 - 1) * kPi / 2) + 1) / f;
  if (t < e.k2) return (ease_in + t - e.k1) / f;
  return (ease_in + straight + ease_out * std::sin((t - e.k2) / (1 - e.k2) * kPi / 2)) / f;
}

std::optional<std::string> invalid(const ParabolicEase& e) {
  return breaks_problem(e.t1, e.t2, "t1", "t2");
}

// Parent, 3.2.4: the area under a trapezoid of height v0 is 1.
double shape(const ParabolicEase& e, double t) {
  const double v0 = 2 / (e.t2 - e.t1 + 1);
  if (t < e.t1) return v0 * t * t / (2 * e.t1);
  if (t < e.t2) return v0 * e.t1 / 2 + v0 * (t - e.t1);
  return 1 - v0 * (1 - t) * (1 - t) / (2 * (1 - e.t2));
}

std::optional<std::string> invalid(const CubicBezierEase& e) {
  if (!in_unit(e.x1) || !in_unit(e.x2)) return "x1 and x2 of a cubic Bezier must lie in [0, 1]";
  if (!std::isfinite(e.y1) || !std::isfinite(e.y2)) return "y1 and y2 of a cubic Bezier must be finite numbers";
  return std::nullopt;
}

// One coordinate of the Bezier curve 0, a, b, 1 at u, and its derivative.
double bezier(double a, double b, double u) {
  const double v = 1 - u;
  return u * (3 * v * (v * a + u * b) + u * u);
}
double bezier_slope(double a, double b, double u) {
  const double v = 1 - u;
  return 3 * (v * v * a + 2 * u * v * (b - a) + u * u * (1 - b));
}

// x(u) = t by Newton inside a shrinking bracket. x rises since x1 and x2 are in [0, 1], but its slope may be 0 (handles
// at 1 and 0): then the bracket's middle is used.
double shape(const CubicBezierEase& e, double t) {
  constexpr int kIterations = 80;
  constexpr double kPrecision = 1e-15;
  double low = 0, high = 1, u = t;
  for (int i = 0; i < kIterations && high - low > kPrecision; ++i) {
    const double error = bezier(e.x1, e.x2, u) - t;
    if (error == 0) break;
    (error > 0 ? high : low) = u;
    const double next = u - error / bezier_slope(e.x1, e.x2, u);
    const bool inside = next > low && next < high;  // false for NaN and infinity, too
    if (inside && std::abs(next - u) < kPrecision) break;
    u = inside ? next : (low + high) / 2;
  }
  return bezier(e.y1, e.y2, u);
}

std::optional<std::string> invalid(const StepEase& e) {
  if (in_unit(e.at)) return std::nullopt;
  return "the place of a step must lie in [0, 1]";
}
double shape(const StepEase& e, double t) {
  return t < e.at ? 0 : 1;
}

std::optional<std::string> invalid(const KeysEase& e) {
  const auto& keys = e.keys;
  const auto finite = [](const KeysEase::Key& key) {
    return std::isfinite(key.t) && std::isfinite(key.s) && std::isfinite(key.speed.value_or(0));
  };
  const auto not_rising = [](const KeysEase::Key& a, const KeysEase::Key& b) { return a.t >= b.t; };
  if (keys.size() < 2) return "distance keys need at least two keys, one at time 0 and one at time 1";
  if (!std::ranges::all_of(keys, finite)) return "times, distances and speeds of keys must be finite numbers";
  if (keys.front().t != 0 || keys.back().t != 1) return "the first key must be at time 0 and the last at time 1";
  if (std::ranges::adjacent_find(keys, not_rising) != keys.end()) return "the times of keys must rise strictly";
  return std::nullopt;
}
double shape(const KeysEase& e, double t) {
  return monotone_at(e.keys, t);
}

double end_value(const Easing& easing, bool last) {
  if (const auto* keys = std::get_if<KeysEase>(&easing)) return last ? keys->keys.back().s : keys->keys.front().s;
  return last ? 1 : 0;
}

}  // namespace

std::optional<std::string> problem(const Easing& easing) {
  return std::visit([](const auto& e) { return invalid(e); }, easing);
}

double ease(const Easing& easing, double t) {
  if (!(t > 0)) return end_value(easing, false);
  if (t >= 1) return end_value(easing, true);
  return std::visit([t](const auto& e) { return shape(e, t); }, easing);
}

double progress(const Timing& timing, double t) {
  // Compare before dividing: (1 - 0.1) / 0.9 may differ from 1.
  if (t >= timing.delay + timing.duration) return ease(timing.easing, 1);
  if (t <= timing.delay) return ease(timing.easing, 0);
  return ease(timing.easing, (t - timing.delay) / timing.duration);
}

}  // namespace morphkit::motion
