#include "morph/media/raw_frame.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "warp/image/color.h"

namespace morphkit::media {
namespace {

using Bytes = std::vector<std::uint8_t>;

warp::Image constant(cv::Size size, warp::Pixel pixel) {
  return warp::Image(size, pixel);
}

int code16(const Bytes& bytes, std::size_t index) {
  return bytes[2 * index] | bytes[2 * index + 1] << 8;
}

TEST(RawFrame, RgbIsRoundedToTheNearestCode) {
  warp::Image image(1, 256);
  for (int code = 0; code < 256; ++code) {
    const float nearly = (static_cast<float>(code) + (code % 2 == 0 ? 0.45F : -0.45F)) / 255.0F;
    const float linear = warp::linear_from_srgb(nearly);
    image(0, code) = {linear, linear, linear, 1.0F};
  }
  const Bytes bytes = raw_frame(image, RawFormat::kRgb24, image.size());
  ASSERT_EQ(bytes.size(), 3U * 256U);
  for (int i = 0; i < 3 * 256; ++i) EXPECT_EQ(bytes[i], i / 3);
}

TEST(RawFrame, EverySixteenBitCodeSurvives) {
  warp::Image image(256, 256);
  for (int code = 0; code < 65536; ++code) {
    const float linear = warp::linear_from_srgb(static_cast<float>(code) / 65535.0F);
    image(code / 256, code % 256) = {linear, 0.0F, linear, 1.0F};
  }
  const Bytes bytes = raw_frame(image, RawFormat::kRgb48, image.size());
  for (int code = 0; code < 65536; ++code) {
    ASSERT_EQ(code16(bytes, 3 * code), code);
    ASSERT_EQ(code16(bytes, 3 * code + 1), 0);
  }
}

TEST(RawFrame, HasTheBt709CodesOfColourBars) {
  // Rec. ITU-R BT.709-6 with 8-bit limited range, as in every table of colour bars.
  struct Bar {
    warp::Pixel colour;
    std::array<int, 3> codes;
  };
  const std::array<Bar, 8> bars = {{{{1, 1, 1, 1}, {235, 128, 128}},
                                    {{1, 1, 0, 1}, {219, 16, 138}},
                                    {{0, 1, 1, 1}, {188, 154, 16}},
                                    {{0, 1, 0, 1}, {173, 42, 26}},
                                    {{1, 0, 1, 1}, {78, 214, 230}},
                                    {{1, 0, 0, 1}, {63, 102, 240}},
                                    {{0, 0, 1, 1}, {32, 240, 118}},
                                    {{0, 0, 0, 1}, {16, 128, 128}}}};
  for (const Bar& bar : bars) {
    const Bytes bytes = raw_frame(constant({4, 2}, bar.colour), RawFormat::kYuv420p, {4, 2});
    ASSERT_EQ(bytes.size(), 8U + 2U + 2U);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(bytes[i], bar.codes[0]) << bar.colour;
    for (int i = 8; i < 10; ++i) EXPECT_EQ(bytes[i], bar.codes[1]) << bar.colour;
    for (int i = 10; i < 12; ++i) EXPECT_EQ(bytes[i], bar.codes[2]) << bar.colour;
    const Bytes deep = raw_frame(constant({4, 1}, bar.colour), RawFormat::kYuv422p10, {4, 1});
    ASSERT_EQ(deep.size(), 2U * (4U + 2U + 2U));
    EXPECT_NEAR(code16(deep, 0), 4 * bar.codes[0], 2) << bar.colour;
    EXPECT_NEAR(code16(deep, 4), 4 * bar.codes[1], 2) << bar.colour;
    EXPECT_NEAR(code16(deep, 6), 4 * bar.codes[2], 2) << bar.colour;
  }
}

TEST(RawFrame, ChromaLiesOnEvenColumnsBetweenRows) {
  // Red alone, with a linear slope of its code: halved chroma must be the value of the slope at its place.
  const cv::Size size(16, 8);
  const auto red = [](double x, double y) { return 0.1 + 0.04 * x + 0.02 * y; };
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      image(y, x) = {warp::linear_from_srgb(static_cast<float>(red(x, y))), 0.0F, 0.0F, 1.0F};
  const Bytes bytes = raw_frame(image, RawFormat::kYuv420p, size);
  const Bytes deep = raw_frame(image, RawFormat::kYuv422p10, size);
  for (int y = 0; y < 4; ++y) {
    for (int x = 1; x < 8; ++x) {
      const double cr = 128 + 224 * (1 - 0.2126) * red(2 * x, 2 * y + 0.5) / 1.5748;
      EXPECT_NEAR(bytes[128 + 32 + 8 * y + x], cr, 0.501);
      const double deep_cr = 4 * (128 + 224 * (1 - 0.2126) * red(2 * x, 2 * y) / 1.5748);
      EXPECT_NEAR(code16(deep, 128 + 64 + 8 * (2 * y) + x), deep_cr, 0.51);
    }
  }
}

TEST(RawFrame, MissingColumnsAndRowsRepeatTheLast) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0F; };
  warp::Image odd(5, 7);
  for (warp::Pixel& pixel : odd) pixel = {unit(), unit(), unit(), 1.0F};
  warp::Image even(6, 8);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) even(y, x) = odd(std::min(y, 4), std::min(x, 6));
  for (const auto format : {RawFormat::kYuv420p, RawFormat::kRgb24})
    EXPECT_EQ(raw_frame(odd, format, {8, 6}), raw_frame(even, format, {8, 6}));
}

TEST(RawFrame, OddSizesHaveRoundedUpChroma) {
  const warp::Image image = constant({7, 5}, {1, 0, 0, 1});
  const Bytes bytes = raw_frame(image, RawFormat::kYuva420p, image.size());
  ASSERT_EQ(bytes.size(), 35U + 12U + 12U + 35U);
  EXPECT_EQ(bytes[35 + 11], 102);
  EXPECT_EQ(bytes[35 + 12 + 11], 240);
  EXPECT_EQ(bytes[35 + 24 + 34], 255);
}

TEST(RawFrame, IsUnpremultipliedOrOverBlack) {
  const float half = warp::linear_from_srgb(200.0F / 255.0F);
  const warp::Image image = constant({2, 2}, {0.5F * half, 0.0F, 0.5F, 0.5F});
  const Bytes straight = raw_frame(image, RawFormat::kRgba, image.size());
  EXPECT_EQ(Bytes(straight.begin(), straight.begin() + 4), (Bytes{200, 0, 255, 128}));
  const Bytes black = raw_frame(image, RawFormat::kRgb24, image.size());
  const auto code = [](float linear) {
    return static_cast<std::uint8_t>(std::lround(255.0F * warp::srgb_from_linear(linear)));
  };
  EXPECT_EQ(Bytes(black.begin(), black.begin() + 3), (Bytes{code(0.5F * half), 0, code(0.5F)}));
  const Bytes deep = raw_frame(image, RawFormat::kRgba64, image.size());
  EXPECT_EQ(code16(deep, 3), 32768);
  const Bytes nothing = raw_frame(constant({2, 2}, {0, 0, 0, 0}), RawFormat::kRgba, {2, 2});
  EXPECT_EQ(nothing, Bytes(16, 0));
}

TEST(RawFrame, ValuesOutsideAndNotANumberAreClamped) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const auto format : {RawFormat::kRgba, RawFormat::kRgba64}) {
    const std::size_t width = format == RawFormat::kRgba ? 1 : 2;
    const auto codes = [&](warp::Pixel pixel) { return raw_frame(constant({1, 1}, pixel), format, {1, 1}); };
    const auto expected = [&](std::initializer_list<int> values) {
      Bytes all;
      for (const int value : values) all.insert(all.end(), width, static_cast<std::uint8_t>(value));
      return all;
    };
    EXPECT_EQ(codes({-1.0F, 7.0F, infinity, 1.0F}), expected({0, 255, 255, 255}));
    EXPECT_EQ(codes({nan, -infinity, 1e38F, 2.0F}), expected({0, 0, 255, 255}));
    // Transparent pixels get colour 0, as in an image file.
    EXPECT_EQ(codes({1.0F, 1.0F, 0.0F, nan}), expected({0, 0, 0, 0}));
    EXPECT_EQ(codes({1.0F, nan, 0.0F, 1.0F}), expected({255, 0, 0, 255}));
  }
  const Bytes yuv = raw_frame(constant({2, 2}, {9.0F, nan, -9.0F, 1.0F}), RawFormat::kYuv420p, {2, 2});
  EXPECT_EQ(yuv, (Bytes{63, 63, 63, 63, 102, 240}));
}

TEST(RawFrame, AnImageThatDoesNotFitIsABrokenContract) {
  EXPECT_THROW(raw_frame(constant({3, 2}, {}), RawFormat::kRgb24, {2, 2}), std::invalid_argument);
  EXPECT_THROW(raw_frame(warp::Image(), RawFormat::kRgb24, {2, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace morphkit::media
