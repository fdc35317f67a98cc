#pragma once
// Timing curves: progress as a function of time.

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace morphkit::motion {

struct LinearEase {
  bool operator==(const LinearEase&) const = default;
};
/// (sin(pi t - pi/2) + 1) / 2.
struct SineEase {
  bool operator==(const SineEase&) const = default;
};
/// Ease-in until k1, constant speed, ease-out from k2, made of sine pieces (Parent eq. 3.18). 0 <= k1 <= k2 <= 1.
struct SinusoidalEase {
  double k1 = 0.3, k2 = 0.7;
  bool operator==(const SinusoidalEase&) const = default;
};
/// Constant acceleration until t1, constant speed, constant deceleration from t2 (Parent 3.2.4). 0 <= t1 <= t2 <= 1.
struct ParabolicEase {
  double t1 = 0.3, t2 = 0.7;
  bool operator==(const ParabolicEase&) const = default;
};
/// CSS-style cubic Bezier from (0, 0) to (1, 1) with two handles; x1 and x2 in [0, 1].
struct CubicBezierEase {
  double x1 = 0.25, y1 = 0.1, x2 = 0.25, y2 = 1.0;
  bool operator==(const CubicBezierEase&) const = default;
};
/// 0 before `at`, 1 from `at` on. At t = 0 always 0 and at t = 1 always 1.
struct StepEase {
  double at = 0.5;
  bool operator==(const StepEase&) const = default;
};
/// Distance keys (t, s), t strictly rising from 0 to 1, joined by a monotone cubic (Fritsch-Carlson); a key may give
/// its speed ds/dt, else the monotone choice is used.
struct KeysEase {
  struct Key {
    double t = 0, s = 0;
    std::optional<double> speed;
    bool operator==(const Key&) const = default;
  };
  std::vector<Key> keys;
  bool operator==(const KeysEase&) const = default;
};

using Easing = std::variant<LinearEase, SineEase, SinusoidalEase, ParabolicEase, CubicBezierEase, StepEase, KeysEase>;

/// What is wrong with the parameters and what would be right, in one sentence; nullopt if they are good.
std::optional<std::string> problem(const Easing& easing);

/// Progress at t in [0, 1] (clamped). f(0) = 0 and f(1) = 1 exactly, except that KeysEase gives its own end values.
/// A cubic Bezier or keys may leave [0, 1] in between. @pre !problem(easing).
double ease(const Easing& easing, double t);

/// An easing that starts late and runs for part of the time.
struct Timing {
  Easing easing = LinearEase{};
  double delay = 0;     ///< fraction of the transition before the start, [0, 1]
  double duration = 1;  ///< fraction of the transition, >= 0; 0 is a jump at `delay`
  bool operator==(const Timing&) const = default;
};

/// ease(timing.easing, (t - delay) / duration), with the fraction clamped to [0, 1]. With delay + duration <= 1 the
/// ends are exact: progress(0) = 0 (unless a jump at 0) and progress(1) = 1.
double progress(const Timing& timing, double t);

}  // namespace morphkit::motion
