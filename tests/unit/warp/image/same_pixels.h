#pragma once
// The comparison that kernels of rows must pass against their references.

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::test {

/// Equal bits; any NaN equals any NaN.
inline bool same_pixels(const std::vector<warp::Pixel>& a, const std::vector<warp::Pixel>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (int c = 0; c < 4; ++c) {
      if (std::isnan(a[k][c]) && std::isnan(b[k][c])) continue;
      if (std::bit_cast<std::uint32_t>(a[k][c]) != std::bit_cast<std::uint32_t>(b[k][c])) return false;
    }
  }
  return true;
}

}  // namespace morphkit::test
