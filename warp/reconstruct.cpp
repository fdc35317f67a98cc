#include "warp/reconstruct.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core/hal/intrin.hpp>

namespace morphkit::warp::detail {
namespace {

using Vec = cv::v_float32x4;  // one RGBA pixel

Vec load(const Pixel& pixel) {
  return cv::v_load(pixel.val);
}

/// The source without the weight of cv::Mat.
class Source {
 public:
  explicit Source(const Image& image) : data_(image.data), step_(image.step[0]), size_(image.size()) {}

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  const Pixel* row(int y) const { return reinterpret_cast<const Pixel*>(data_ + static_cast<std::size_t>(y) * step_); }

 private:
  const uchar* data_;
  std::size_t step_;
  cv::Size size_;
};

/// The largest float that is not above `value`.
float float_not_above(int value) {
  const float rounded = static_cast<float>(value);
  if (static_cast<double>(rounded) <= value) return rounded;
  return std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

/// The positions whose taps all exist, so that nothing need be asked about the border.
class Interior {
 public:
  /// @param before, after  taps on either side of the position's floor.
  Interior(const Source& source, int before, int after)
      : begin_(static_cast<float>(before)),
        end_x_(float_not_above(source.width() - after)),
        end_y_(float_not_above(source.height() - after)) {}

  /// False for NaN. Where true, both fit an int and truncation is floor.
  bool contains(float x, float y) const { return x >= begin_ && x < end_x_ && y >= begin_ && y < end_y_; }

 private:
  float begin_, end_x_, end_y_;
};

/// How many pixels ahead of its use a source pixel is fetched. A row of a warp wanders over many source rows, which the
/// hardware does not foresee: without this a 1080p warp takes twice as long (bench_sample).
constexpr std::size_t kFetchAhead = 32;

const MapPoint& ahead_of(std::span<const MapPoint> positions, std::size_t i) {
  return positions[std::min(i + kFetchAhead, positions.size() - 1)];
}

// A kernel is separable and weighs kTaps samples, the first of which lies kBefore pixels before the position's floor.
// Both are written as "one tap plus weighted differences from it": a constant comes out unchanged, to the bit, so an
// opaque image stays opaque.

struct Bilinear {
  static constexpr int kTaps = 2;
  static constexpr int kBefore = 0;

  explicit Bilinear(float fraction) : w1_(cv::v_setall_f32(fraction)) {}
  Vec operator()(const Vec (&tap)[kTaps]) const { return tap[0] + w1_ * (tap[1] - tap[0]); }
  static Vec finish(const Vec& value) { return value; }

 private:
  Vec w1_;
};

/// Cubic convolution with a = -1/2, third order accurate, which is Catmull-Rom: Keys, "Cubic Convolution Interpolation
/// for Digital Image Processing", IEEE ASSP 29 (1981), eq. 15.
struct Bicubic {
  static constexpr int kTaps = 4;
  static constexpr int kBefore = 1;

  explicit Bicubic(float f)
      : w0_(cv::v_setall_f32(f * (f * (1.0F - 0.5F * f) - 0.5F))),
        w2_(cv::v_setall_f32(f * (f * (2.0F - 1.5F * f) + 0.5F))),
        w3_(cv::v_setall_f32(0.5F * f * f * (f - 1.0F))) {}
  Vec operator()(const Vec (&tap)[kTaps]) const {
    return tap[1] + (w0_ * (tap[0] - tap[1]) + (w2_ * (tap[2] - tap[1]) + w3_ * (tap[3] - tap[1])));
  }
  /// The negative lobes overshoot; a coverage outside [0, 1] would have no meaning, a colour outside has.
  static Vec finish(const Vec& value) {
    constexpr float kMax = std::numeric_limits<float>::max();
    return cv::v_min(cv::v_max(value, Vec(-kMax, -kMax, -kMax, 0.0F)), Vec(kMax, kMax, kMax, 1.0F));
  }

 private:
  Vec w0_, w2_, w3_;
};

/// The weighted sum; tap(j, i) is the pixel of tap row j and tap column i. The same arithmetic inside and at the
/// border: there is no seam between them.
template <typename Taps, typename Tap>
Pixel convolve(float fraction_x, float fraction_y, const Tap& tap) {
  const Taps across(fraction_x);
  Vec rows[Taps::kTaps];
  for (int j = 0; j < Taps::kTaps; ++j) {
    Vec taps[Taps::kTaps];
    for (int i = 0; i < Taps::kTaps; ++i) taps[i] = tap(j, i);
    rows[j] = across(taps);
  }
  Pixel result;
  cv::v_store(result.val, Taps::finish(Taps(fraction_y)(rows)));
  return result;
}

/// A position on one axis as the pixel before it and the way to the next.
struct Place {
  std::int64_t base;
  float fraction;
};

/// Finds the place of any finite position, counted from the centre of pixel 0, without overflow: a position farther out
/// than the widest kernel reaches is replaced by one that sees the same pixels.
template <Border kBorder>
Place place(double position, int size) {
  constexpr double kReach = 4;
  if constexpr (kBorder == Border::kMirror) {
    position = std::fmod(position, 2.0 * size);
  } else {
    position = std::clamp(position, -kReach, size + kReach);
  }
  const double base = std::floor(position);
  return {static_cast<std::int64_t>(base), static_cast<float>(position - base)};
}

/// The pixel that stands at `index` of an axis; -1 if none does.
template <Border kBorder>
int resolve(std::int64_t index, int size) {
  if (index >= 0 && index < size) return static_cast<int>(index);
  if constexpr (kBorder == Border::kTransparent) return -1;
  if constexpr (kBorder == Border::kClamp) return index < 0 ? 0 : size - 1;
  // Reflected at the edge, which lies half a pixel outside the last centre: the edge pixel appears twice.
  const std::int64_t period = 2 * static_cast<std::int64_t>(size);
  const std::int64_t phase = ((index % period) + period) % period;
  return static_cast<int>(phase < size ? phase : period - 1 - phase);
}

/// The pixel that stands at (x, y), by the border's rule.
template <Border kBorder>
Vec pixel_at(const Source& source, int x, int y) {
  if constexpr (kBorder == Border::kTransparent) {
    if (x < 0 || y < 0) return cv::v_setzero_f32();
  }
  return load(source.row(y)[x]);
}

bool is_finite(const MapPoint& position) {
  return std::isfinite(position[0]) && std::isfinite(position[1]);
}

/// Any position at all; slow.
template <typename Taps, Border kBorder>
[[gnu::noinline]] Pixel filter_border(const Source& source, const MapPoint& position) {
  if (!is_finite(position)) return Pixel::all(0);
  const Place x = place<kBorder>(position[0] - 0.5, source.width());
  const Place y = place<kBorder>(position[1] - 0.5, source.height());
  const auto column = [&](int i) { return resolve<kBorder>(x.base - Taps::kBefore + i, source.width()); };
  const auto row = [&](int j) { return resolve<kBorder>(y.base - Taps::kBefore + j, source.height()); };
  if (x.fraction == 0 && y.fraction == 0) {
    const int i = column(Taps::kBefore);
    const int j = row(Taps::kBefore);
    return i < 0 || j < 0 ? Pixel::all(0) : source.row(j)[i];
  }
  int columns[Taps::kTaps];
  int rows[Taps::kTaps];
  for (int i = 0; i < Taps::kTaps; ++i) {
    columns[i] = column(i);
    rows[i] = row(i);
  }
  return convolve<Taps>(x.fraction, y.fraction,
                        [&](int j, int i) { return pixel_at<kBorder>(source, columns[i], rows[j]); });
}

template <typename Taps, Border kBorder>
void filter_row(const Source& source, std::span<const MapPoint> positions, std::span<Pixel> out) {
  constexpr int kAfter = Taps::kTaps - 1 - Taps::kBefore;
  const Interior interior(source, Taps::kBefore, kAfter);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    // Downwards through the output, the lowest tap row is usually the one not yet in the cache.
    const MapPoint ahead = ahead_of(positions, i) - MapPoint(0.5F, 0.5F);
    if (interior.contains(ahead[0], ahead[1])) {
      __builtin_prefetch(source.row(static_cast<int>(ahead[1]) + kAfter) + static_cast<int>(ahead[0]));
    }
    const float u = positions[i][0] - 0.5F;
    const float v = positions[i][1] - 0.5F;
    if (!interior.contains(u, v)) [[unlikely]] {
      out[i] = filter_border<Taps, kBorder>(source, positions[i]);
      continue;
    }
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const float fraction_x = u - static_cast<float>(x);
    const float fraction_y = v - static_cast<float>(y);
    if (fraction_x == 0 && fraction_y == 0) {
      out[i] = source.row(y)[x];
      continue;
    }
    out[i] = convolve<Taps>(fraction_x, fraction_y, [&](int tap_y, int tap_x) {
      return load(source.row(y - Taps::kBefore + tap_y)[x - Taps::kBefore + tap_x]);
    });
  }
}

template <Border kBorder>
[[gnu::noinline]] Pixel nearest_border(const Source& source, const MapPoint& position) {
  if (!is_finite(position)) return Pixel::all(0);
  const int x = resolve<kBorder>(place<kBorder>(position[0], source.width()).base, source.width());
  const int y = resolve<kBorder>(place<kBorder>(position[1], source.height()).base, source.height());
  return x < 0 || y < 0 ? Pixel::all(0) : source.row(y)[x];
}

template <Border kBorder>
void nearest_row(const Source& source, std::span<const MapPoint> positions, std::span<Pixel> out) {
  const Interior interior(source, 0, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const MapPoint& ahead = ahead_of(positions, i);
    if (interior.contains(ahead[0], ahead[1])) {
      __builtin_prefetch(source.row(static_cast<int>(ahead[1])) + static_cast<int>(ahead[0]));
    }
    const float x = positions[i][0];
    const float y = positions[i][1];
    out[i] = interior.contains(x, y) ? source.row(static_cast<int>(y))[static_cast<int>(x)]
                                     : nearest_border<kBorder>(source, positions[i]);
  }
}

template <Border kBorder>
void row_with_border(const Source& source, std::span<const MapPoint> positions, Kernel kernel, std::span<Pixel> out) {
  switch (kernel) {
    case Kernel::kNearest:
      return nearest_row<kBorder>(source, positions, out);
    case Kernel::kBilinear:
      return filter_row<Bilinear, kBorder>(source, positions, out);
    case Kernel::kBicubic:
      return filter_row<Bicubic, kBorder>(source, positions, out);
  }
}

}  // namespace

void reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                     std::span<Pixel> out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  const Source view(source);
  switch (border) {
    case Border::kTransparent:
      return row_with_border<Border::kTransparent>(view, positions, kernel, out);
    case Border::kClamp:
      return row_with_border<Border::kClamp>(view, positions, kernel, out);
    case Border::kMirror:
      return row_with_border<Border::kMirror>(view, positions, kernel, out);
  }
}

}  // namespace morphkit::warp::detail
