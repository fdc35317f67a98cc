#include "morph/motion/monotone_keys.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace morphkit::motion {
namespace {

using Key = KeysEase::Key;

double width(const std::vector<Key>& keys, std::size_t i) {
  return keys[i + 1].t - keys[i].t;
}
double secant(const std::vector<Key>& keys, std::size_t i) {
  return (keys[i + 1].s - keys[i].s) / width(keys, i);
}

// Slopes in [0, 3 secant] at both ends make a cubic monotone: the square inside Fritsch & Carlson's region. Unlike
// their circle it limits each key by itself, so a given speed next door does not matter.
double limited(double slope, double secant) {
  return secant >= 0 ? std::clamp(slope, 0.0, 3 * secant) : std::clamp(slope, 3 * secant, 0.0);
}

// Slope at the near end of the parabola through three keys; `near` and `far` are the two intervals by distance from it.
double end_slope(double near_width, double near_secant, double far_width, double far_secant) {
  const double slope =
      ((2 * near_width + far_width) * near_secant - near_width * far_secant) / (near_width + far_width);
  return limited(slope, near_secant);
}

double speed(const std::vector<Key>& keys, std::size_t i) {
  if (keys[i].speed) return *keys[i].speed;
  const std::size_t last = keys.size() - 1;
  if (last == 1) return secant(keys, 0);
  if (i == 0) return end_slope(width(keys, 0), secant(keys, 0), width(keys, 1), secant(keys, 1));
  if (i == last) {
    return end_slope(width(keys, i - 1), secant(keys, i - 1), width(keys, i - 2), secant(keys, i - 2));
  }
  const double before = secant(keys, i - 1), after = secant(keys, i);
  if (before * after <= 0) return 0;  // a local extreme stays one
  const double h_before = width(keys, i - 1), h_after = width(keys, i);
  const double parabola = (h_after * before + h_before * after) / (h_before + h_after);
  return limited(limited(parabola, before), after);
}

}  // namespace

double monotone_at(const std::vector<Key>& keys, double t) {
  const auto after =
      std::upper_bound(keys.begin() + 1, keys.end() - 1, t, [](double x, const Key& k) { return x < k.t; });
  const auto i = static_cast<std::size_t>(std::distance(keys.begin(), after)) - 1;
  const double h = width(keys, i), u = (t - keys[i].t) / h, v = 1 - u;
  // The Hermite basis, grouped by key so that u = 0 and u = 1 give the keys exactly.
  return v * v * ((1 + 2 * u) * keys[i].s + u * h * speed(keys, i)) +
         u * u * ((1 + 2 * v) * keys[i + 1].s - v * h * speed(keys, i + 1));
}

}  // namespace morphkit::motion
