#include "morph/media/pixel_codec.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "morph/media/color_profile.h"
#include "warp/image/color.h"
#include "warp/image/color_rows.h"

namespace morphkit::media {
namespace {

constexpr int kLargest8 = 255;
constexpr int kLargest16 = 65535;

template <typename Sample>
constexpr float kLargest = static_cast<float>(sizeof(Sample) == 1 ? kLargest8 : kLargest16);

template <typename Sample>
float number(Sample sample) noexcept {
  if constexpr (std::is_same_v<Sample, float>)
    return sample;
  else
    return static_cast<float>(sample) / kLargest<Sample>;
}

/// The pixel, or transparent black if it is not finite; counts that, or else the other faults.
warp::Pixel checked(const warp::Pixel& pixel, float stored_alpha, bool above_alpha, PixelFaults& faults) noexcept {
  if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1]) || !std::isfinite(pixel[2]) ||
      !std::isfinite(stored_alpha)) {
    ++faults.nonfinite;
    return {0, 0, 0, 0};
  }
  faults.alpha_outside += stored_alpha == pixel[3] ? 0 : 1;
  faults.above_alpha += above_alpha ? 1 : 0;
  return pixel;
}

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

}  // namespace

std::size_t sample_bytes(SampleType type) noexcept {
  if (type == SampleType::kU8) return 1;
  return type == SampleType::kU16 ? 2 : sizeof(float);
}

PixelFaults& PixelFaults::operator+=(const PixelFaults& other) noexcept {
  nonfinite += other.nonfinite;
  alpha_outside += other.alpha_outside;
  above_alpha += other.above_alpha;
  return *this;
}

PixelDecoder::PixelDecoder(const StoredLayout& layout) : layout_(layout) {
  if (layout.type == SampleType::kFloat || layout.color.profile) return;
  const int largest = layout.type == SampleType::kU8 ? kLargest8 : kLargest16;
  table_.resize(static_cast<std::size_t>(largest) + 1);
  for (int code = 0; code <= largest; ++code) {
    table_[static_cast<std::size_t>(code)] =
        linear_light(layout.color.transfer, static_cast<float>(code) / static_cast<float>(largest));
  }
}

float PixelDecoder::linear(float stored) const noexcept {
  return linear_light(layout_.color.transfer, stored);
}

template <typename Sample>
PixelFaults PixelDecoder::decode_samples(const Sample* row, int width, warp::Pixel* out) const noexcept {
  constexpr bool kIsFloat = std::is_same_v<Sample, float>;
  const auto straight = [&](Sample sample) {
    if constexpr (kIsFloat)
      return linear(sample);
    else
      return table_[sample];
  };
  const std::array<int, 3> colors = {layout_.r, layout_.g, layout_.b};
  PixelFaults faults;
  for (int x = 0; x < width; ++x, row += layout_.channels) {
    const float stored_alpha = layout_.a < 0 ? 1.0F : number(row[layout_.a]);
    const float alpha = std::clamp(stored_alpha, 0.0F, 1.0F);
    bool above_alpha = false;
    warp::Pixel pixel(0, 0, 0, alpha);
    for (int c = 0; c < 3; ++c) {
      if (colors[c] < 0) continue;
      const Sample sample = row[colors[c]];
      const bool is_multiplied = layout_.a >= 0 && layout_.alpha != AlphaKind::kStraight;
      if (is_multiplied && !kIsFloat && number(sample) > alpha) {
        pixel[c] = alpha;
        above_alpha = true;
      } else if (layout_.a < 0 || layout_.alpha == AlphaKind::kPremultiplied) {
        pixel[c] = straight(sample);
      } else if (!is_multiplied) {
        pixel[c] = straight(sample) * alpha;
      } else {
        pixel[c] = alpha > 0 ? linear(number(sample) / alpha) * alpha : 0.0F;
      }
    }
    out[x] = checked(pixel, stored_alpha, above_alpha, faults);
  }
  return faults;
}

/// A profile speaks of colours without alpha, so a premultiplied one is divided first.
template <typename Sample>
PixelFaults PixelDecoder::decode_profiled(const Sample* row, int width, warp::Pixel* out) const noexcept {
  const auto sample = [&](int x, int channel) {
    return channel < 0 ? 0.0F : number(row[x * layout_.channels + channel]);
  };
  const auto alpha_of = [&](int x) { return layout_.a < 0 ? 1.0F : sample(x, layout_.a); };
  const bool divide = layout_.a >= 0 && layout_.alpha != AlphaKind::kStraight;
  PixelFaults faults;
  for (int x = 0; x < width; ++x) {
    const float alpha = alpha_of(x);
    out[x] = warp::Pixel(sample(x, layout_.r), sample(x, layout_.g), sample(x, layout_.b), sample(x, layout_.k));
    if (!divide) continue;
    bool above_alpha = false;
    for (int c = 0; c < 3; ++c) {
      if (!std::is_same_v<Sample, float> && out[x][c] > alpha) {
        out[x][c] = alpha;
        above_alpha = true;
      }
      out[x][c] = alpha > 0 ? out[x][c] / alpha : 0.0F;
    }
    faults.above_alpha += above_alpha ? 1 : 0;
  }
  layout_.color.profile->apply(std::span(out, static_cast<std::size_t>(width)));
  for (int x = 0; x < width; ++x) {
    const float stored_alpha = alpha_of(x), alpha = std::clamp(stored_alpha, 0.0F, 1.0F);
    const warp::Pixel pixel(out[x][0] * alpha, out[x][1] * alpha, out[x][2] * alpha, alpha);
    out[x] = checked(pixel, stored_alpha, false, faults);
  }
  return faults;
}

template <typename Sample>
PixelFaults PixelDecoder::decode_kind(const void* row, int width, warp::Pixel* out) const noexcept {
  const auto* samples = static_cast<const Sample*>(row);
  return layout_.color.profile ? decode_profiled(samples, width, out) : decode_samples(samples, width, out);
}

PixelFaults PixelDecoder::decode(const void* row, int width, warp::Pixel* out) const noexcept {
  switch (layout_.type) {
    case SampleType::kU8:
      return decode_kind<std::uint8_t>(row, width, out);
    case SampleType::kU16:
      return decode_kind<std::uint16_t>(row, width, out);
    case SampleType::kFloat:
      break;
  }
  return decode_kind<float>(row, width, out);
}

void PixelEncoder::encode(const warp::Pixel* pixels, int width, void* row) const noexcept {
  const std::span<const warp::Pixel> all(pixels, static_cast<std::size_t>(width));
  switch (type_) {
    case SampleType::kU8:
      return warp::srgb_codes(all, channels_, static_cast<std::uint8_t*>(row));
    case SampleType::kU16:
      return warp::srgb_codes(all, channels_, static_cast<std::uint16_t*>(row));
    case SampleType::kFloat:
      break;
  }
  float* out = static_cast<float*>(row);
  for (const warp::Pixel& pixel : all) out = std::copy_n(pixel.val, channels_, out);
}

}  // namespace morphkit::media
