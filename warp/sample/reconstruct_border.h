#pragma once
// How an image continues beyond its border; shared by the reference and the kernel of reconstruct_row. Internal.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "warp/sample/border.h"

namespace morphkit::warp::detail {

/// A position on one axis: the pixel before it, and the fraction of the way to the next.
struct Place {
  std::int64_t base;
  float fraction;
};

/// The place of any finite position, counted from the centre of pixel 0, without overflow: a position beyond the reach
/// of the widest kernel is replaced by one that reads the same pixels.
inline Place place(double position, int size, Border border) {
  constexpr double kReach = 4;
  if (border == Border::kMirror) {
    position = std::fmod(position, 2.0 * size);
  } else {
    position = std::clamp(position, -kReach, size + kReach);
  }
  const double base = std::floor(position);
  return {static_cast<std::int64_t>(base), static_cast<float>(position - base)};
}

}  // namespace morphkit::warp::detail
