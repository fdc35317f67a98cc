#include "morph/render/dissolve.h"

#include "warp/image/color.h"
#include "warp/image/mix.h"

namespace morphkit::render {
namespace {

/// Premultiplied linear <-> premultiplied display-referred.
template <float (*Convert)(float) noexcept>
warp::Pixel converted(const warp::Pixel& pixel) noexcept {
  const float alpha = pixel[3];
  if (alpha <= 0) return {0, 0, 0, alpha};
  warp::Pixel result(0, 0, 0, alpha);
  for (int c = 0; c < 3; ++c) result[c] = Convert(pixel[c] / alpha) * alpha;
  return result;
}

}  // namespace

void dissolve_row(std::span<warp::Pixel> source, std::span<const warp::Pixel> destination, std::span<const float> alpha,
                  project::Blend blend) noexcept {
  if (blend == project::Blend::kLinear) return warp::mix_row(source, destination, alpha);
  const std::size_t step = alpha.size() == 1 ? 0 : 1;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const float a = alpha[i * step];
    if (a <= 0) continue;
    if (a >= 1) {
      source[i] = destination[i];
    } else {
      warp::Pixel mixed = converted<warp::srgb_from_linear>(source[i]);
      const warp::Pixel other = converted<warp::srgb_from_linear>(destination[i]);
      warp::mix_row({&mixed, 1}, {&other, 1}, {&a, 1});
      source[i] = converted<warp::linear_from_srgb>(mixed);
    }
  }
}

void over_row(std::span<warp::Pixel> row, std::span<const warp::Pixel> behind) noexcept {
  const std::size_t step = behind.size() == 1 ? 0 : 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const float rest = 1 - row[i][3];
    if (rest == 0) continue;
    for (int c = 0; c < 4; ++c) row[i][c] += rest * behind[i * step][c];
  }
}

}  // namespace morphkit::render
