#pragma once
// The monotone cubic through distance keys.

#include <vector>

#include "morph/motion/easing.h"

namespace morphkit::motion {

/// The distance at time t: a cubic Hermite between neighbouring keys. A key without a speed gets one that keeps every
/// piece between such keys monotone. A given speed is used unchanged.
/// @pre !problem(KeysEase{keys}) and 0 <= t <= 1. Cost: O(log keys).
/// Fritsch and Carlson, "Monotone Piecewise Cubic Interpolation", 1980.
double monotone_at(const std::vector<KeysEase::Key>& keys, double t);

}  // namespace morphkit::motion
