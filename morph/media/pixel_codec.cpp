#include "morph/media/pixel_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "warp/color.h"

namespace morphkit::media {
namespace {

constexpr int kLargest8 = 255;
constexpr int kLargest16 = 65535;

template <typename Sample>
constexpr float kLargest = static_cast<float>(sizeof(Sample) == 1 ? kLargest8 : kLargest16);

float linear_light(const Transfer& transfer, float stored) noexcept {
  switch (transfer.kind) {
    case Transfer::Kind::kSrgb:
      return warp::linear_from_srgb(stored);
    case Transfer::Kind::kGamma:
      return std::copysign(std::pow(std::abs(stored), transfer.gamma), stored);
    case Transfer::Kind::kLinear:
      break;
  }
  return stored;
}

const SrgbQuantizer& quantizer_for(SampleType type) {
  if (type == SampleType::kU8) {
    static const SrgbQuantizer quantizer(kLargest8);
    return quantizer;
  }
  static const SrgbQuantizer quantizer(kLargest16);
  return quantizer;
}

// Buckets of the quantizer: the upper bits of a float's representation, 1024 buckets per power of two, from 2^-24
// (below half a 16-bit code) to 1.
constexpr int kBucketShift = 23 - 10;
constexpr std::uint32_t kFirstBucket = std::bit_cast<std::uint32_t>(0x1p-24F) >> kBucketShift;
constexpr std::uint32_t kLastBucket = std::bit_cast<std::uint32_t>(1.0F) >> kBucketShift;

}  // namespace

std::size_t sample_bytes(SampleType type) noexcept {
  if (type == SampleType::kU8) return 1;
  return type == SampleType::kU16 ? 2 : sizeof(float);
}

PixelDecoder::PixelDecoder(const StoredLayout& layout) : layout_(layout) {
  if (layout.type == SampleType::kFloat) return;
  const int largest = layout.type == SampleType::kU8 ? kLargest8 : kLargest16;
  table_.resize(static_cast<std::size_t>(largest) + 1);
  for (int code = 0; code <= largest; ++code) {
    table_[static_cast<std::size_t>(code)] =
        linear_light(layout.transfer, static_cast<float>(code) / static_cast<float>(largest));
  }
}

float PixelDecoder::linear(float stored) const noexcept {
  return linear_light(layout_.transfer, stored);
}

template <typename Sample>
std::int64_t PixelDecoder::decode_samples(const Sample* row, int width, warp::Pixel* out) const noexcept {
  constexpr bool kIsFloat = std::is_same_v<Sample, float>;
  const auto number = [](Sample sample) {
    if constexpr (kIsFloat)
      return sample;
    else
      return static_cast<float>(sample) / kLargest<Sample>;
  };
  const auto straight = [&](Sample sample) {
    if constexpr (kIsFloat)
      return linear(sample);
    else
      return table_[sample];
  };
  const std::array<int, 3> colors = {layout_.r, layout_.g, layout_.b};
  std::int64_t nonfinite = 0;
  for (int x = 0; x < width; ++x, row += layout_.channels) {
    const float alpha = layout_.a < 0 ? 1.0F : number(row[layout_.a]);
    warp::Pixel pixel(0, 0, 0, alpha);
    for (int c = 0; c < 3; ++c) {
      if (colors[c] < 0) continue;
      const Sample sample = row[colors[c]];
      if (layout_.a < 0 || layout_.alpha == AlphaKind::kPremultiplied) {
        pixel[c] = straight(sample);
      } else if (layout_.alpha == AlphaKind::kStraight) {
        pixel[c] = straight(sample) * alpha;
      } else {
        pixel[c] = alpha > 0 ? linear(number(sample) / alpha) * alpha : 0.0F;
      }
    }
    const bool finite =
        std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]) && std::isfinite(pixel[3]);
    out[x] = finite ? pixel : warp::Pixel(0, 0, 0, 0);
    nonfinite += finite ? 0 : 1;
  }
  return nonfinite;
}

std::int64_t PixelDecoder::decode(const void* row, int width, warp::Pixel* out) const noexcept {
  switch (layout_.type) {
    case SampleType::kU8:
      return decode_samples(static_cast<const std::uint8_t*>(row), width, out);
    case SampleType::kU16:
      return decode_samples(static_cast<const std::uint16_t*>(row), width, out);
    case SampleType::kFloat:
      break;
  }
  return decode_samples(static_cast<const float*>(row), width, out);
}

SrgbQuantizer::SrgbQuantizer(int largest) : largest_(largest) {
  threshold_.resize(static_cast<std::size_t>(largest));
  for (int code = 0; code < largest; ++code) {
    const double boundary = (code + 0.5) / largest;
    threshold_[static_cast<std::size_t>(code)] = warp::linear_from_srgb(static_cast<float>(boundary));
  }
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

PixelEncoder::PixelEncoder(SampleType type, int channels)
    : type_(type), channels_(channels), quantizer_(type == SampleType::kFloat ? nullptr : &quantizer_for(type)) {}

template <typename Sample>
void PixelEncoder::encode_codes(const warp::Pixel* pixels, int width, Sample* row) const noexcept {
  const SrgbQuantizer& quantize = *quantizer_;
  for (int x = 0; x < width; ++x, row += channels_) {
    const warp::Pixel& pixel = pixels[x];
    const float alpha = pixel[3];
    // Opaque pixels skip the division, which would be by exactly 1; without coverage there is no colour to tell.
    const bool divide = channels_ == 4 && alpha != 1.0F;
    const bool empty = channels_ == 4 && !(alpha > 0);
    for (int c = 0; c < 3; ++c) {
      const float color = divide ? pixel[c] / alpha : pixel[c];
      row[c] = empty ? Sample{0} : static_cast<Sample>(quantize(color));
    }
    if (channels_ < 4) continue;
    const float covered = empty ? 0.0F : std::min(alpha, 1.0F);
    row[3] = static_cast<Sample>(std::lround(covered * kLargest<Sample>));
  }
}

void PixelEncoder::encode(const warp::Pixel* pixels, int width, void* row) const noexcept {
  switch (type_) {
    case SampleType::kU8:
      encode_codes(pixels, width, static_cast<std::uint8_t*>(row));
      return;
    case SampleType::kU16:
      encode_codes(pixels, width, static_cast<std::uint16_t*>(row));
      return;
    case SampleType::kFloat:
      break;
  }
  float* out = static_cast<float*>(row);
  for (int x = 0; x < width; ++x, out += channels_) std::copy_n(pixels[x].val, channels_, out);
}

}  // namespace morphkit::media
