// The specification of the kernels in color_rows_simd.cpp, and code that both share.

#include "warp/image/color_rows.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

#include "warp/image/color.h"

namespace morphkit::warp {
namespace {

// Buckets of the quantizer: the upper bits of a float's representation, 1024 buckets per power of two, from 2^-24
// (below half a 16-bit code) to 1.
constexpr int kBucketShift = 23 - 10;
constexpr std::uint32_t kFirstBucket = std::bit_cast<std::uint32_t>(0x1p-24F) >> kBucketShift;
constexpr std::uint32_t kLastBucket = std::bit_cast<std::uint32_t>(1.0F) >> kBucketShift;

/// Clamps to [0, 1]; NaN becomes 0.
float unit(float value) noexcept {
  return value > 0.0F ? std::min(value, 1.0F) : 0.0F;
}

template <typename Code>
Code nearest_code(float value) noexcept {
  return static_cast<Code>(std::lrint(value));
}

}  // namespace

SrgbQuantizer::SrgbQuantizer(int largest) : largest_(largest) {
  threshold_.resize(static_cast<std::size_t>(largest));
  for (int code = 0; code < largest; ++code) {
    const double boundary = (code + 0.5) / largest;
    threshold_[static_cast<std::size_t>(code)] = linear_from_srgb(static_cast<float>(boundary));
  }
  first_.reserve(kLastBucket - kFirstBucket + 1);
  for (std::uint32_t bucket = kFirstBucket; bucket <= kLastBucket; ++bucket) {
    const float begin = std::bit_cast<float>(bucket << kBucketShift);
    const auto above = std::upper_bound(threshold_.begin(), threshold_.end(), begin);
    first_.push_back(static_cast<std::uint16_t>(above - threshold_.begin()));
  }
}

std::uint16_t SrgbQuantizer::operator()(float linear) const noexcept {
  if (!(linear >= 0x1p-24F)) return 0;
  if (linear >= 1.0F) return static_cast<std::uint16_t>(largest_);
  int code = first_[(std::bit_cast<std::uint32_t>(linear) >> kBucketShift) - kFirstBucket];
  while (code < largest_ && linear >= threshold_[static_cast<std::size_t>(code)]) ++code;
  return static_cast<std::uint16_t>(code);
}

template <typename Code>
const SrgbQuantizer& SrgbQuantizer::of() {
  static const SrgbQuantizer quantizer(std::numeric_limits<Code>::max());
  return quantizer;
}

template <typename Code>
void reference_srgb_codes(std::span<const Pixel> pixels, int channels, Code* codes) noexcept {
  const SrgbQuantizer& quantize = SrgbQuantizer::of<Code>();
  for (const Pixel& pixel : pixels) {
    const float alpha = pixel[3];
    const bool straight = channels == 4;
    const bool empty = straight && !(alpha > 0);
    for (int c = 0; c < 3; ++c) {
      *codes++ = empty ? Code{0} : static_cast<Code>(quantize(straight ? pixel[c] / alpha : pixel[c]));
    }
    if (straight) *codes++ = nearest_code<Code>(unit(alpha) * static_cast<float>(std::numeric_limits<Code>::max()));
  }
}

float display_from_linear(float linear) noexcept {
  const float value = unit(linear);
  if (value < detail::kCurveBreak) return value * detail::kCurveSlope;
  const float root = std::sqrt(std::sqrt(value)) - detail::kCurveMiddle;
  float sum = *std::rbegin(detail::kCurve);
  for (auto factor = std::rbegin(detail::kCurve) + 1; factor != std::rend(detail::kCurve); ++factor)
    sum = sum * root + *factor;
  return std::min(sum, 1.0F);
}

DisplayRow::DisplayRow(std::size_t width) : width_(width), stride_(width + 2 * kMargin), values_(4 * stride_) {}

void reference_to_display(std::span<const Pixel> pixels, bool straight, DisplayRow& row) noexcept {
  assert(!pixels.empty() && pixels.size() <= row.width());
  for (std::size_t x = 0; x < row.width(); ++x) {
    const Pixel& pixel = pixels[std::min(x, pixels.size() - 1)];
    const float divisor = straight && pixel[3] > 0.0F ? pixel[3] : 1.0F;
    for (int c = 0; c < 3; ++c) row.plane(c)[x] = display_from_linear(pixel[c] / divisor);
    row.plane(3)[x] = unit(pixel[3]);
  }
  for (int c = 0; c < 4; ++c) {
    row.plane(c)[-1] = row.plane(c)[0];
    row.plane(c)[row.width()] = row.plane(c)[row.width() - 1];
  }
}

void reference_mean_row(const DisplayRow& upper, const DisplayRow& lower, int across, DisplayRow& out) noexcept {
  for (int c = 0; c < 3; ++c) {
    const auto mean = [&](std::ptrdiff_t x) { return 0.5F * (upper.plane(c)[x] + lower.plane(c)[x]); };
    for (std::size_t i = 0; i < out.width(); ++i) {
      const auto x = static_cast<std::ptrdiff_t>(i) * across;
      out.plane(c)[i] = across == 1 ? mean(x) : 0.25F * (mean(x - 1) + mean(x + 1)) + 0.5F * mean(x);
    }
  }
}

template <typename Code>
void reference_weighted_codes(const DisplayRow& row, const CodeWeights& weights, Code* codes) noexcept {
  for (std::size_t x = 0; x < row.width(); ++x) {
    float sum = weights.offset;
    for (int c = 0; c < 4; ++c) sum = sum + weights.weight[c] * row.plane(c)[x];
    codes[x] = nearest_code<Code>(sum);
  }
}

template const SrgbQuantizer& SrgbQuantizer::of<std::uint8_t>();
template const SrgbQuantizer& SrgbQuantizer::of<std::uint16_t>();
template void reference_srgb_codes(std::span<const Pixel>, int, std::uint8_t*) noexcept;
template void reference_srgb_codes(std::span<const Pixel>, int, std::uint16_t*) noexcept;
template void reference_weighted_codes(const DisplayRow&, const CodeWeights&, std::uint8_t*) noexcept;
template void reference_weighted_codes(const DisplayRow&, const CodeWeights&, std::uint16_t*) noexcept;

}  // namespace morphkit::warp
