// The plain form of reconstruct_row; reconstruct_simd.cpp has the fast one.

#include "warp/sample/reconstruct.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include "warp/sample/reconstruct_border.h"

namespace morphkit::warp::detail {
namespace {

// A kernel is separable and weighs kTaps samples; the first lies kBefore pixels before the position's floor. Columns
// are combined first. Both kernels are written as "one tap plus weighted differences from it": a constant stays the
// same to the bit, so an opaque image stays opaque. The order of the operations is part of the specification.

struct Bilinear {
  static constexpr int kTaps = 2;
  static constexpr int kBefore = 0;

  explicit Bilinear(float fraction) : w1_(fraction) {}
  float down(const float (&tap)[kTaps]) const { return tap[0] + w1_ * (tap[1] - tap[0]); }
  float across(const float (&tap)[kTaps]) const { return down(tap); }
  static void finish(Pixel&) {}

 private:
  float w1_;
};

/// Cubic convolution with a = -1/2, which is Catmull-Rom, accurate to third order: Keys, "Cubic Convolution
/// Interpolation for Digital Image Processing", IEEE ASSP 29 (1981), eq. 15.
struct Bicubic {
  static constexpr int kTaps = 4;
  static constexpr int kBefore = 1;

  explicit Bicubic(float f)
      : w0_(f * (f * (1.0F - 0.5F * f) - 0.5F)),
        w2_(f * (f * (2.0F - 1.5F * f) + 0.5F)),
        w3_(0.5F * f * f * (f - 1.0F)) {}
  float down(const float (&tap)[kTaps]) const {
    return tap[1] + (w0_ * (tap[0] - tap[1]) + (w2_ * (tap[2] - tap[1]) + w3_ * (tap[3] - tap[1])));
  }
  /// In the order that suits taps side by side in a vector.
  float across(const float (&tap)[kTaps]) const {
    return (w0_ * (tap[0] - tap[1]) + w2_ * (tap[2] - tap[1])) + (tap[1] + w3_ * (tap[3] - tap[1]));
  }
  /// The negative lobes overshoot. Alpha outside [0, 1] has no meaning and is clamped; colours stay. NaN stays.
  static void finish(Pixel& pixel) { pixel[3] = std::min(std::max(pixel[3], 0.0F), 1.0F); }

 private:
  float w0_, w2_, w3_;
};

Pixel pixel_at(const Image& source, int x, int y) {
  return x < 0 || y < 0 ? Pixel::all(0) : source(y, x);
}

template <typename Taps>
Pixel filtered(const Image& source, const MapPoint& position, Border border) {
  const Place x = place(position[0] - 0.5, source.cols, border);
  const Place y = place(position[1] - 0.5, source.rows, border);
  const auto tap = [&](int i, int j) {
    return pixel_at(source, index_within(x.base - Taps::kBefore + i, source.cols, border),
                    index_within(y.base - Taps::kBefore + j, source.rows, border));
  };
  if (x.fraction == 0 && y.fraction == 0) return tap(Taps::kBefore, Taps::kBefore);
  const Taps across(x.fraction);
  const Taps down(y.fraction);
  float column[4][Taps::kTaps];  // by channel
  for (int i = 0; i < Taps::kTaps; ++i) {
    Pixel taps[Taps::kTaps];
    for (int j = 0; j < Taps::kTaps; ++j) taps[j] = tap(i, j);
    for (int c = 0; c < 4; ++c) {
      float values[Taps::kTaps];
      for (int j = 0; j < Taps::kTaps; ++j) values[j] = taps[j][c];
      column[c][i] = down.down(values);
    }
  }
  Pixel result;
  for (int c = 0; c < 4; ++c) result[c] = across.across(column[c]);
  Taps::finish(result);
  return result;
}

Pixel nearest(const Image& source, const MapPoint& position, Border border) {
  return pixel_at(source, index_within(place(position[0], source.cols, border).base, source.cols, border),
                  index_within(place(position[1], source.rows, border).base, source.rows, border));
}

}  // namespace

void reference_reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                               std::span<Pixel> out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const MapPoint& position = positions[i];
    if (!std::isfinite(position[0]) || !std::isfinite(position[1])) {
      out[i] = Pixel::all(0);
    } else if (kernel == Kernel::kNearest) {
      out[i] = nearest(source, position, border);
    } else {
      out[i] = kernel == Kernel::kBilinear ? filtered<Bilinear>(source, position, border)
                                           : filtered<Bicubic>(source, position, border);
    }
  }
}

}  // namespace morphkit::warp::detail
