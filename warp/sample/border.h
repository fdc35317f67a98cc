#pragma once
// Pixels beyond the border of an image. Internal to warp.

#include <cstdint>

#include "warp/sample/sample.h"

namespace morphkit::warp::detail {

/// The pixel to read at `index` of an axis of `size` pixels; -1 if there is none.
inline int index_within(std::int64_t index, int size, Border border) noexcept {
  if (index >= 0 && index < size) return static_cast<int>(index);
  if (border == Border::kTransparent) return -1;
  if (border == Border::kClamp) return index < 0 ? 0 : size - 1;
  // The mirror is the edge, half a pixel outside the last centre, so the edge pixel appears twice.
  const std::int64_t period = 2 * static_cast<std::int64_t>(size);
  const std::int64_t phase = ((index % period) + period) % period;
  return static_cast<int>(phase < size ? phase : period - 1 - phase);
}

}  // namespace morphkit::warp::detail
