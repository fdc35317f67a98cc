#include "warp/image/mix.h"

#include <cassert>
#include <cstddef>

namespace morphkit::warp {

void reference_mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept {
  assert(a.size() == b.size());
  assert(alpha.size() == 1 || alpha.size() == a.size());
  const std::size_t step = alpha.size() == 1 ? 0 : 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const float weight = alpha[i * step];
    if (weight <= 0) continue;
    if (weight >= 1) {
      a[i] = b[i];
      continue;
    }
    for (int c = 0; c < 4; ++c) a[i][c] = (1 - weight) * a[i][c] + weight * b[i][c];
  }
}

}  // namespace morphkit::warp
