// The kernels of color_rows.h: float lanes over the pixels of a row. They repeat the operations of the reference one by
// one, without fused multiply-adds, so the results are the same bits.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <iterator>
#include <limits>

#include "base/kernel_targets.h"
#include "warp/image/color_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/image/color_rows_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using FloatVec = hn::Vec<Floats>;
using Ints = hn::RebindToSigned<Floats>;
constexpr size_t kMostLanes = 16;

/// Clamps to [0, 1]; NaN becomes 0.
HWY_INLINE FloatVec unit(FloatVec value) {
  const Floats d;
  const FloatVec positive = hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value);
  return hn::Min(positive, hn::Set(d, 1.0F));
}

/// display_from_linear of values in [0, 1].
HWY_INLINE FloatVec display(FloatVec value) {
  const Floats d;
  const FloatVec root = hn::Sub(hn::Sqrt(hn::Sqrt(value)), hn::Set(d, kCurveMiddle));
  FloatVec sum = hn::Set(d, *std::rbegin(kCurve));
  for (auto factor = std::rbegin(kCurve) + 1; factor != std::rend(kCurve); ++factor)
    sum = hn::Add(hn::Mul(sum, root), hn::Set(d, *factor));
  const FloatVec straight = hn::Mul(value, hn::Set(d, kCurveSlope));
  return hn::IfThenElse(hn::Lt(value, hn::Set(d, kCurveBreak)), straight, hn::Min(sum, hn::Set(d, 1.0F)));
}

/// Calls fn(values, first, count) with each whole vector of pixels, and with a padded copy of the rest.
template <class Fn>
HWY_INLINE void for_vectors(std::span<const Pixel> pixels, const Fn& fn) {
  const size_t lanes = hn::Lanes(Floats());
  size_t x = 0;
  for (; x + lanes <= pixels.size(); x += lanes) fn(pixels[x].val, x, lanes);
  if (x == pixels.size()) return;
  std::array<float, 4 * kMostLanes> padded{};
  std::memcpy(padded.data(), pixels[x].val, (pixels.size() - x) * sizeof(Pixel));
  fn(padded.data(), x, pixels.size() - x);
}

// ---- Interleaved codes.

/// Codes of clamped linear values. The curve is accurate enough to choose the nearest code, except near the boundary
/// between two codes: there the quantizer decides.
template <typename Code>
HWY_INLINE hn::Vec<Ints> codes_of(FloatVec linear, const SrgbQuantizer& quantize) {
  const Floats d;
  const Ints di;
  constexpr auto kTop = static_cast<float>(std::numeric_limits<Code>::max());
  // The error of the curve, and as much again for the quantizer's boundaries as floats and for the rounding here.
  constexpr float kDoubt = 2 * kDisplayTolerance * kTop;
  const FloatVec exact = hn::Mul(display(linear), hn::Set(d, kTop));
  hn::Vec<Ints> codes = hn::NearestInt(exact);
  const FloatVec off = hn::Abs(hn::Sub(exact, hn::ConvertTo(d, codes)));
  const auto doubtful = hn::Gt(off, hn::Set(d, 0.5F - kDoubt));
  if (hn::AllFalse(d, doubtful)) return codes;
  alignas(64) float values[kMostLanes];
  alignas(64) int32_t asked[kMostLanes];
  uint8_t bits[8] = {};
  hn::Store(linear, d, values);
  hn::Store(codes, di, asked);
  hn::StoreMaskBits(d, doubtful, bits);
  for (unsigned left = bits[0] | static_cast<unsigned>(bits[1]) << 8; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    asked[i] = quantize(values[i]);
  }
  return hn::Load(di, asked);
}

template <typename Code, int kChannels>
void interleaved(std::span<const Pixel> pixels, Code* codes) {
  const Floats d;
  const hn::Rebind<Code, Floats> dc;
  const SrgbQuantizer& quantize = SrgbQuantizer::of<Code>();
  const FloatVec top = hn::Set(d, static_cast<float>(std::numeric_limits<Code>::max()));
  const auto store = [&](const float* values, Code* out) {
    FloatVec r, g, b, a;
    hn::LoadInterleaved4(d, values, r, g, b, a);
    if constexpr (kChannels == 4) {
      const auto covered = hn::Gt(a, hn::Zero(d));
      r = hn::IfThenElseZero(covered, hn::Div(r, a));
      g = hn::IfThenElseZero(covered, hn::Div(g, a));
      b = hn::IfThenElseZero(covered, hn::Div(b, a));
    }
    const auto red = hn::DemoteTo(dc, codes_of<Code>(unit(r), quantize));
    const auto green = hn::DemoteTo(dc, codes_of<Code>(unit(g), quantize));
    const auto blue = hn::DemoteTo(dc, codes_of<Code>(unit(b), quantize));
    if constexpr (kChannels == 4) {
      const auto alpha = hn::DemoteTo(dc, hn::NearestInt(hn::Mul(unit(a), top)));
      hn::StoreInterleaved4(red, green, blue, alpha, dc, out);
    } else {
      hn::StoreInterleaved3(red, green, blue, dc, out);
    }
  };
  for_vectors(pixels, [&](const float* values, size_t first, size_t count) {
    if (count == hn::Lanes(d)) return store(values, codes + first * kChannels);
    std::array<Code, kChannels * kMostLanes> padded;
    store(values, padded.data());
    std::memcpy(codes + first * kChannels, padded.data(), count * kChannels * sizeof(Code));
  });
}

void srgb_codes_8(std::span<const Pixel> pixels, int channels, uint8_t* codes) {
  (channels == 4 ? interleaved<uint8_t, 4> : interleaved<uint8_t, 3>)(pixels, codes);
}

void srgb_codes_16(std::span<const Pixel> pixels, int channels, uint16_t* codes) {
  (channels == 4 ? interleaved<uint16_t, 4> : interleaved<uint16_t, 3>)(pixels, codes);
}

// ---- Planes.

void display_planes(std::span<const Pixel> pixels, bool straight, DisplayRow& row) {
  const Floats d;
  const FloatVec one = hn::Set(d, 1.0F);
  for_vectors(pixels, [&](const float* values, size_t first, size_t) {
    FloatVec r, g, b, a;
    hn::LoadInterleaved4(d, values, r, g, b, a);
    if (straight) {
      const FloatVec divisor = hn::IfThenElse(hn::Gt(a, hn::Zero(d)), a, one);
      r = hn::Div(r, divisor);
      g = hn::Div(g, divisor);
      b = hn::Div(b, divisor);
    }
    hn::StoreU(display(unit(r)), d, row.plane(0) + first);
    hn::StoreU(display(unit(g)), d, row.plane(1) + first);
    hn::StoreU(display(unit(b)), d, row.plane(2) + first);
    hn::StoreU(unit(a), d, row.plane(3) + first);
  });
}

void mean_planes(const DisplayRow& upper, const DisplayRow& lower, int across, DisplayRow& out) {
  const Floats d;
  const FloatVec half = hn::Set(d, 0.5F);
  const FloatVec quarter = hn::Set(d, 0.25F);
  const auto mean = [&](FloatVec a, FloatVec b) { return hn::Mul(half, hn::Add(a, b)); };
  for (int c = 0; c < 3; ++c) {
    const float* const above = upper.plane(c);
    const float* const below = lower.plane(c);
    float* const to = out.plane(c);
    for (size_t i = 0; i < out.width(); i += hn::Lanes(d)) {
      if (across == 1) {
        hn::StoreU(mean(hn::LoadU(d, above + i), hn::LoadU(d, below + i)), d, to + i);
        continue;
      }
      FloatVec left_above, at_above, right_above, left_below, at_below, right_below, unused;
      hn::LoadInterleaved2(d, above + 2 * i - 1, left_above, at_above);
      hn::LoadInterleaved2(d, below + 2 * i - 1, left_below, at_below);
      hn::LoadInterleaved2(d, above + 2 * i + 1, right_above, unused);
      hn::LoadInterleaved2(d, below + 2 * i + 1, right_below, unused);
      const FloatVec sides = hn::Add(mean(left_above, left_below), mean(right_above, right_below));
      hn::StoreU(hn::Add(hn::Mul(quarter, sides), hn::Mul(half, mean(at_above, at_below))), d, to + i);
    }
  }
}

template <typename Code>
void sums_as_codes(const DisplayRow& row, const CodeWeights& weights, Code* codes) {
  const Floats d;
  const hn::Rebind<Code, Floats> dc;
  const auto at = [&](size_t x) {
    FloatVec sum = hn::Set(d, weights.offset);
    for (int c = 0; c < 4; ++c)
      sum = hn::Add(sum, hn::Mul(hn::Set(d, weights.weight[c]), hn::LoadU(d, row.plane(c) + x)));
    return hn::DemoteTo(dc, hn::NearestInt(sum));
  };
  size_t x = 0;
  for (; x + hn::Lanes(d) <= row.width(); x += hn::Lanes(d)) hn::StoreU(at(x), dc, codes + x);
  if (x == row.width()) return;
  alignas(64) Code padded[kMostLanes];
  hn::Store(at(x), dc, padded);
  std::memcpy(codes + x, padded, (row.width() - x) * sizeof(Code));
}

void weighted_codes_8(const DisplayRow& row, const CodeWeights& weights, uint8_t* codes) {
  sums_as_codes(row, weights, codes);
}

void weighted_codes_16(const DisplayRow& row, const CodeWeights& weights, uint16_t* codes) {
  sums_as_codes(row, weights, codes);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp {
namespace detail {
HWY_EXPORT(srgb_codes_8);
HWY_EXPORT(srgb_codes_16);
HWY_EXPORT(display_planes);
HWY_EXPORT(mean_planes);
HWY_EXPORT(weighted_codes_8);
HWY_EXPORT(weighted_codes_16);
}  // namespace detail

template <>
void srgb_codes(std::span<const Pixel> pixels, int channels, std::uint8_t* codes) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::srgb_codes_8)(pixels, channels, codes);
}

template <>
void srgb_codes(std::span<const Pixel> pixels, int channels, std::uint16_t* codes) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::srgb_codes_16)(pixels, channels, codes);
}

void to_display(std::span<const Pixel> pixels, bool straight, DisplayRow& row) noexcept {
  assert(!pixels.empty() && pixels.size() <= row.width());
  HWY_DYNAMIC_DISPATCH(detail::display_planes)(pixels, straight, row);
  for (int c = 0; c < 4; ++c) {
    float* const plane = row.plane(c);
    std::fill(plane + pixels.size(), plane + row.width() + 1, plane[pixels.size() - 1]);
    plane[-1] = plane[0];
  }
}

void mean_row(const DisplayRow& upper, const DisplayRow& lower, int across, DisplayRow& out) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::mean_planes)(upper, lower, across, out);
}

template <>
void weighted_codes(const DisplayRow& row, const CodeWeights& weights, std::uint8_t* codes) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::weighted_codes_8)(row, weights, codes);
}

template <>
void weighted_codes(const DisplayRow& row, const CodeWeights& weights, std::uint16_t* codes) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::weighted_codes_16)(row, weights, codes);
}

}  // namespace morphkit::warp
#endif  // HWY_ONCE
