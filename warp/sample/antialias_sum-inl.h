// The weighted mean of the source over a footprint. Included by antialias_simd.cpp once per instruction set.

#if defined(MORPHKIT_WARP_ANTIALIAS_SUM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_ANTIALIAS_SUM_INL_H_
#undef MORPHKIT_WARP_ANTIALIAS_SUM_INL_H_
#else
#define MORPHKIT_WARP_ANTIALIAS_SUM_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "hwy/highway.h"
#include "warp/sample/antialias.h"
#include "warp/sample/antialias_footprint-inl.h"
#include "warp/sample/border.h"
#include "warp/sample/filters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// No footprint reaches farther, px. The largest is a sheared area: 22.6 (1/2 + 2).
constexpr int kFarthest = 64;

/// For values between -128 and 2^22.
HWY_INLINE int floor_of(float value) {
  return static_cast<int>(value + 128) - 128;
}
HWY_INLINE int ceil_of(float value) {
  return -floor_of(-value);
}

/// Sums weights, and weighted differences of pixels from one pixel.
class PixelSum {
 public:
#if HWY_TARGET == HWY_SCALAR
  HWY_INLINE explicit PixelSum(const Pixel& from) : from_(from) {}

  /// @param count  1, the number of weights.
  HWY_INLINE void add(const float* pixels, FloatVec weights, size_t count) {
    if (count == 0) return;
    weight_ += hn::GetLane(weights);
    for (int c = 0; c < 4; ++c) sum_[c] += hn::GetLane(weights) * (pixels[c] - from_[c]);
  }

  HWY_INLINE Pixel mean() const {
    Pixel mean;
    for (int c = 0; c < 4; ++c) mean[c] = from_[c] + sum_[c] / weight_;
    return mean;
  }

 private:
  Pixel from_, sum_ = Pixel::all(0);
  float weight_ = 0;
#else
  HWY_INLINE explicit PixelSum(const Pixel& from) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    HWY_ALIGN float copy[4] = {from.val[0], from.val[1], from.val[2], from.val[3]};
    from_ = hn::LoadDup128(d, copy);
    pixel_of_lane_ = hn::ShiftRight<2>(hn::Iota(di, 0));
    weight_ = even_ = odd_ = hn::Zero(d);
  }

  /// One weight per lane: first those of `count` pixels, then zeros.
  HWY_INLINE void add(const float* pixels, FloatVec weights, size_t count) {
    weight_ = hn::Add(weight_, weights);
    for (size_t i = 0; i < count; i += 2 * kPixels) {
      add_vector(pixels + 4 * i, weights, i, count - i, even_);
      if (i + kPixels < count) add_vector(pixels + 4 * (i + kPixels), weights, i + kPixels, count - i - kPixels, odd_);
    }
  }

  HWY_INLINE Pixel mean() const {
    const Floats d;
    const FloatVec weight = hn::SumOfLanes(d, weight_);
    HWY_ALIGN float lanes[4 * kPixels];
    hn::Store(hn::Div(hn::Add(even_, odd_), weight), d, lanes);
    HWY_ALIGN float from[4 * kPixels];
    hn::Store(from_, d, from);
    Pixel mean;
    for (size_t c = 0; c < 4; ++c) {
      float sum = 0;
      for (size_t i = 0; i < kPixels; ++i) sum += lanes[4 * i + c];
      mean.val[c] = from[c] + sum;
    }
    return mean;
  }

 private:
  static constexpr size_t kPixels = hn::MaxLanes(Floats()) / 4;  ///< in a vector

  HWY_INLINE void add_vector(const float* pixels, FloatVec weights, size_t first, size_t left, FloatVec& sum) const {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const auto index = hn::IndicesFromVec(d, hn::Add(pixel_of_lane_, hn::Set(di, static_cast<int32_t>(first))));
    const FloatVec weight = hn::TableLookupLanes(weights, index);
    FloatVec values;
    if (left >= kPixels) {
      values = hn::LoadU(d, pixels);
    } else {
      values = hn::MaskedLoad(hn::FirstN(d, 4 * left), d, pixels);
    }
    sum = hn::MulAdd(weight, hn::Sub(values, from_), sum);
  }

  FloatVec from_, weight_, even_, odd_;
  hn::Vec<hn::RebindToSigned<Floats> > pixel_of_lane_;
#endif
};

/// A footprint among the source's pixels. Columns and rows are counted from the pixel that contains the position.
struct Place {
  Place(float position, int size, Border border) {
    position = std::clamp(position, -kFarthestPosition, kFarthestPosition);
    // Farther out than any footprint reaches, all pixels are the same, or mirrored.
    if (position < -kFarthest || position > static_cast<float>(size) + kFarthest) {
      const double whole = std::floor(static_cast<double>(position));
      base = static_cast<int>(border == Border::kMirror ? std::fmod(whole, 2.0 * size)
                                                        : std::clamp<double>(whole, -kFarthest, size + kFarthest));
      fraction = static_cast<float>(static_cast<double>(position) - whole);
    } else {
      base = static_cast<int>(position + kFarthest) - kFarthest;
      if (static_cast<float>(base) > position) --base;
      fraction = position - static_cast<float>(base);
    }
  }
  int base;
  float fraction;  ///< from the pixel's near edge
};

/// The weights along a row of the source.
template <typename Filter>
class RowWeights {
 public:
  HWY_INLINE RowWeights(const Footprints& f, size_t i)
      : f_(f), i_(i), u_(f.ux[i], f.u_reach[i]), v_(f.vx[i], f.v_reach[i]) {
    const Floats d;
    u_half_ = hn::Set(d, Filter::kIsSlab ? f.u_half[i] : 0);
    v_half_ = hn::Set(d, Filter::kIsSlab ? f.v_half[i] : 0);
    u_steps_ = hn::Mul(hn::Set(d, f.ux[i]), hn::Iota(d, 0));
    v_steps_ = hn::Mul(hn::Set(d, f.vx[i]), hn::Iota(d, 0));
  }

  /// Goes to the row at `dy` from the position. Outside begin() .. end() weights are 0.
  HWY_INLINE void set_row(float dy) {
    u_row_ = f_.uy[i_] * dy;
    v_row_ = f_.vy[i_] * dy;
    const float u_middle = -u_row_ * u_.inverse, v_middle = -v_row_ * v_.inverse;
    begin_ = std::max(-f_.x_reach[i_], std::max(u_middle - u_.reach, v_middle - v_.reach));
    end_ = std::min(f_.x_reach[i_], std::min(u_middle + u_.reach, v_middle + v_.reach));
  }
  float begin() const { return begin_; }
  float end() const { return end_; }

  /// Weights from the pixel with its centre at `dx` from the position.
  HWY_INLINE FloatVec at(float dx) const {
    const Floats d;
    const FloatVec u = hn::Add(hn::Set(d, u_row_ + f_.ux[i_] * dx), u_steps_);
    const FloatVec v = hn::Add(hn::Set(d, v_row_ + f_.vx[i_] * dx), v_steps_);
    return hn::Mul(axis_weight(Filter(), u, u_half_), axis_weight(Filter(), v, v_half_));
  }

 private:
  /// The part of a row where a coordinate of the footprint is within its reach.
  struct Stretch {
    HWY_INLINE Stretch(float slope, float coordinate_reach) {
      // Nearly parallel to the row, the reach is unlimited.
      constexpr float kLeast = 1e-6F;
      inverse = std::copysign(1 / std::max(std::abs(slope), kLeast), slope);
      reach = coordinate_reach * std::abs(inverse);
    }
    float inverse, reach;
  };

  const Footprints& f_;
  size_t i_;
  Stretch u_, v_;
  FloatVec u_half_, v_half_, u_steps_, v_steps_;
  float u_row_ = 0, v_row_ = 0, begin_ = 0, end_ = 0;
};

template <typename Filter>
class Summer {
 public:
  Summer(const Image& source, Border border) : source_(source), border_(border) {}

  /// The mean over footprint i.
  Pixel mean(const MapPoint& position, const Footprints& f, size_t i) const {
    return finished(mean_over(position, f, i));
  }

 private:
  /// The negative lobes overshoot. Alpha outside [0, 1] has no meaning and is clamped; colours outside have one.
  static Pixel finished(const Pixel& mean) {
    constexpr float kMax = std::numeric_limits<float>::max();
    Pixel result;
    for (int c = 0; c < 4; ++c) result[c] = std::min(std::max(c == 3 ? 0.0F : -kMax, mean[c]), c == 3 ? 1.0F : kMax);
    return result;
  }

  Pixel mean_over(const MapPoint& position, const Footprints& f, size_t i) const {
    const Place x(position[0], source_.cols, border_);
    const Place y(position[1], source_.rows, border_);
    const int left = x.base + ceil_of(x.fraction - 0.5F - f.x_reach[i]);
    const int right = x.base + floor_of(x.fraction - 0.5F + f.x_reach[i]);
    const int top = y.base + ceil_of(y.fraction - 0.5F - f.y_reach[i]);
    const int bottom = y.base + floor_of(y.fraction - 0.5F + f.y_reach[i]);
    if (left >= 0 && right < source_.cols && top >= 0 && bottom < source_.rows) {
      return sum<true>(x, y, top, bottom, RowWeights<Filter>(f, i));
    }
    const bool outside = right < 0 || left >= source_.cols || bottom < 0 || top >= source_.rows;
    if (outside && border_ == Border::kTransparent) return Pixel::all(0);
    return sum<false>(x, y, top, bottom, RowWeights<Filter>(f, i));
  }

  template <bool kInside>
  HWY_INLINE Pixel sum(const Place& x, const Place& y, int top, int bottom, RowWeights<Filter> weights) const {
    const Floats d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    PixelSum sum(pixel_at(x.base, y.base));
    const float to_dx = 0.5F - x.fraction;
    float buffer[kInside ? 1 : 4 * 2 * kFarthest];
    for (int row = top; row <= bottom; ++row) {
      weights.set_row(static_cast<float>(row - y.base) + 0.5F - y.fraction);
      const int first = ceil_of(weights.begin() - to_dx);
      const int count = floor_of(weights.end() - to_dx) - first + 1;
      if (count <= 0) continue;
      const float* pixels = buffer;
      if constexpr (kInside) {
        pixels = source_[row][x.base + first].val;
      } else {
        for (int k = 0; k < count; ++k)
          std::memcpy(buffer + 4 * k, pixel_at(x.base + first + k, row).val, sizeof(Pixel));
      }
      for (int k = 0; k < count; k += lanes) {
        const auto left = static_cast<size_t>(std::min(lanes, count - k));
        const FloatVec all = weights.at(static_cast<float>(first + k) + to_dx);
        sum.add(pixels + ptrdiff_t{4} * k, hn::IfThenElseZero(hn::FirstN(d, left), all), left);
      }
    }
    return sum.mean();
  }

  Pixel pixel_at(int x, int y) const {
    const int column = index_within(x, source_.cols, border_);
    const int row = index_within(y, source_.rows, border_);
    return column < 0 || row < 0 ? Pixel::all(0) : source_(row, column);
  }

  const Image& source_;
  Border border_;
};

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
