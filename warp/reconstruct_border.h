#pragma once
// What the reference and the kernel of reconstruct_row agree on: how an image goes on beyond its border. Internal.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "warp/sample.h"

namespace morphkit::warp::detail {

/// A position on one axis as the pixel before it and the way to the next.
struct Place {
  std::int64_t base;
  float fraction;
};

/// Finds the place of any finite position, counted from the centre of pixel 0, without overflow: a position farther out
/// than the widest kernel reaches is replaced by one that sees the same pixels.
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

/// The pixel that stands at `index` of an axis; -1 if none does.
inline int resolve(std::int64_t index, int size, Border border) {
  if (index >= 0 && index < size) return static_cast<int>(index);
  if (border == Border::kTransparent) return -1;
  if (border == Border::kClamp) return index < 0 ? 0 : size - 1;
  // Reflected at the edge, which lies half a pixel outside the last centre: the edge pixel appears twice.
  const std::int64_t period = 2 * static_cast<std::int64_t>(size);
  const std::int64_t phase = ((index % period) + period) % period;
  return static_cast<int>(phase < size ? phase : period - 1 - phase);
}

}  // namespace morphkit::warp::detail
