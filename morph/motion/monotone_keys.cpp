#include "morph/motion/monotone_keys.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/monotone.h"

namespace morphkit::motion {
namespace {

using Key = KeysEase::Key;

Secant secant(const std::vector<Key>& keys, std::size_t i) {
  const double width = keys[i + 1].t - keys[i].t;
  return {width, (keys[i + 1].s - keys[i].s) / width};
}

double speed(const std::vector<Key>& keys, std::size_t i) {
  if (keys[i].speed) return *keys[i].speed;
  const std::size_t last = keys.size() - 1;
  if (last == 1) return secant(keys, 0).slope;
  if (i == 0) return monotone_end_slope(secant(keys, 0), secant(keys, 1));
  if (i == last) return monotone_end_slope(secant(keys, i - 1), secant(keys, i - 2));
  return monotone_slope(secant(keys, i - 1), secant(keys, i));
}

}  // namespace

double monotone_at(const std::vector<Key>& keys, double t) {
  const auto after =
      std::upper_bound(keys.begin() + 1, keys.end() - 1, t, [](double x, const Key& k) { return x < k.t; });
  const auto i = static_cast<std::size_t>(std::distance(keys.begin(), after)) - 1;
  const double h = secant(keys, i).width, u = (t - keys[i].t) / h, v = 1 - u;
  // The Hermite basis, grouped by key so that u = 0 and u = 1 give the keys exactly.
  return v * v * ((1 + 2 * u) * keys[i].s + u * h * speed(keys, i)) +
         u * u * ((1 + 2 * v) * keys[i + 1].s - v * h * speed(keys, i + 1));
}

}  // namespace morphkit::motion
