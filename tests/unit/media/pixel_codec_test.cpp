// Colour and alpha of stored samples, exhaustively where possible.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "morph/media/pixel_codec.h"
#include "tests/unit/media/image_support.h"
#include "warp/image/color.h"

namespace morphkit::media {
namespace {

template <typename Sample>
std::vector<Sample> round_trip(const std::vector<Sample>& samples, SampleType type) {
  StoredLayout layout;
  layout.type = type;
  const int width = static_cast<int>(samples.size() / 4);
  std::vector<warp::Pixel> pixels(static_cast<std::size_t>(width));
  EXPECT_EQ(PixelDecoder(layout).decode(samples.data(), width, pixels.data()), PixelFaults());
  std::vector<Sample> result(samples.size());
  PixelEncoder(type, 4).encode(pixels.data(), width, result.data());
  return result;
}

TEST(PixelCodec, EveryUnpremultiplied8BitPixelComesBack) {
  std::vector<std::uint8_t> samples;
  for (int alpha = 1; alpha < 256; ++alpha) {
    for (int color = 0; color < 256; ++color) {
      for (const int sample : {color, 255 - color, color ^ 0x5a, alpha})
        samples.push_back(static_cast<std::uint8_t>(sample));
    }
  }
  EXPECT_EQ(round_trip(samples, SampleType::kU8), samples);
}

TEST(PixelCodec, Every16BitColorComesBackUnderAnyAlpha) {
  for (const int alpha : {1, 2, 3, 255, 256, 1000, 32767, 32768, 43210, 65533, 65534, 65535}) {
    SCOPED_TRACE(alpha);
    std::vector<std::uint16_t> samples;
    for (int color = 0; color < 65536; ++color) {
      for (const int sample : {color, 65535 - color, color ^ 0x5a5a, alpha}) {
        samples.push_back(static_cast<std::uint16_t>(sample));
      }
    }
    EXPECT_EQ(round_trip(samples, SampleType::kU16), samples);
  }
}

TEST(PixelCodec, Every16BitAlphaComesBack) {
  std::vector<std::uint16_t> samples;
  for (int alpha = 1; alpha < 65536; ++alpha) {
    for (const int sample : {alpha, 40000, 7, alpha}) samples.push_back(static_cast<std::uint16_t>(sample));
  }
  EXPECT_EQ(round_trip(samples, SampleType::kU16), samples);
}

TEST(PixelCodec, PremultipliesInLinearLight) {
  StoredLayout layout;
  const std::vector<std::uint8_t> half_red = {200, 0, 0, 128};
  warp::Pixel pixel;
  PixelDecoder(layout).decode(half_red.data(), 1, &pixel);
  const float alpha = 128.0F / 255.0F;
  EXPECT_EQ(pixel[0], warp::linear_from_srgb(200.0F / 255.0F) * alpha);
  EXPECT_EQ(pixel[3], alpha);
}

TEST(PixelCodec, AssociatedStoredColorIsDividedBeforeTheTransfer) {
  StoredLayout layout;
  layout.alpha = AlphaKind::kStoredAssociated;
  const std::vector<std::uint8_t> samples = {100, 51, 0, 102, 9, 9, 9, 0};
  std::vector<warp::Pixel> pixels(2);
  PixelDecoder(layout).decode(samples.data(), 2, pixels.data());
  EXPECT_NEAR(pixels[0][0], warp::linear_from_srgb(100.0F / 102.0F) * 0.4F, 1e-6);
  EXPECT_NEAR(pixels[0][1], warp::linear_from_srgb(0.5F) * 0.4F, 1e-6);
  EXPECT_EQ(pixels[1], warp::Pixel(0, 0, 0, 0));
}

TEST(PixelCodec, NonFinitePixelsBecomeTransparentAndAreCounted) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  StoredLayout layout;
  layout.type = SampleType::kFloat;
  layout.alpha = AlphaKind::kPremultiplied;
  layout.color.transfer.kind = Transfer::Kind::kLinear;
  const std::vector<float> samples = {kNan, 0, 0, 1, 0, -kInfinity, 0, 1, 5, -2, 0.5F, 1, 0, 0, 0, kNan};
  std::vector<warp::Pixel> pixels(4);
  EXPECT_EQ(PixelDecoder(layout).decode(samples.data(), 4, pixels.data()), (PixelFaults{.nonfinite = 3}));
  for (const int i : {0, 1, 3}) EXPECT_EQ(pixels[static_cast<std::size_t>(i)], warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(pixels[2], warp::Pixel(5, -2, 0.5F, 1));
}

TEST(PixelCodec, AlphaOutsideIsClampedAndCountedAndColorStays) {
  StoredLayout layout;
  layout.type = SampleType::kFloat;
  layout.color.transfer.kind = Transfer::Kind::kLinear;
  const std::vector<float> samples = {3, -2, 0.5F, 1.5F, 3, -2, 0.5F, -0.25F, 3, 0, 0, 0.5F, 3, 0, 0, INFINITY};
  std::vector<warp::Pixel> pixels(4);
  const PixelFaults expected{.nonfinite = 1, .alpha_outside = 2};
  layout.alpha = AlphaKind::kPremultiplied;
  EXPECT_EQ(PixelDecoder(layout).decode(samples.data(), 4, pixels.data()), expected);
  EXPECT_EQ(pixels[0], warp::Pixel(3, -2, 0.5F, 1));
  EXPECT_EQ(pixels[1], warp::Pixel(3, -2, 0.5F, 0));
  EXPECT_EQ(pixels[2], warp::Pixel(3, 0, 0, 0.5F));  // brighter than alpha: light
  layout.alpha = AlphaKind::kStraight;
  EXPECT_EQ(PixelDecoder(layout).decode(samples.data(), 4, pixels.data()), expected);
  EXPECT_EQ(pixels[0], warp::Pixel(3, -2, 0.5F, 1));
  EXPECT_EQ(pixels[1], warp::Pixel(0, 0, 0, 0));
}

TEST(PixelCodec, IntegersAboveAlphaAreHeldInBothPremultipliedForms) {
  for (const AlphaKind kind : {AlphaKind::kPremultiplied, AlphaKind::kStoredAssociated}) {
    StoredLayout layout;
    layout.type = SampleType::kU16;
    layout.color.transfer.kind = Transfer::Kind::kLinear;
    layout.alpha = kind;
    const std::vector<std::uint16_t> samples = {65535, 0, 1, 2, 9, 8, 0, 0, 13107, 0, 26214, 26214};
    std::vector<warp::Pixel> pixels(3);
    const PixelFaults expected{.above_alpha = 2};
    EXPECT_EQ(PixelDecoder(layout).decode(samples.data(), 3, pixels.data()), expected);
    const float alpha = 2.0F / 65535.0F;
    EXPECT_EQ(pixels[0][0], alpha);
    EXPECT_NEAR(pixels[0][2], 1.0F / 65535.0F, 1e-12);
    EXPECT_EQ(pixels[1], warp::Pixel(0, 0, 0, 0));
    EXPECT_NEAR(pixels[2][0], 0.2, 1e-7);
    EXPECT_EQ(pixels[2][2], 0.4F);
  }
}

}  // namespace
}  // namespace morphkit::media
