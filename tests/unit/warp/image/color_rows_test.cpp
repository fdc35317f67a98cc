// Rows of codes: the properties of the reference, and the kernels against it on every instruction set that this machine
// runs, to the bit.

#include "warp/image/color_rows.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "warp/image/color.h"

namespace morphkit::warp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// sRGB in double precision.
double srgb_exactly(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(SrgbQuantizer, RoundsToTheNearestCode) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> exponent(-26.0F, 0.0F);
  for (const int largest : {255, 65535}) {
    const SrgbQuantizer quantize(largest);
    for (int i = 0; i < 200000; ++i) {
      const float linear = std::exp2(exponent(random));
      const double exact = srgb_exactly(linear) * largest;
      // Half a code, plus the error of a code's boundary as a float: an ulp in 65535 codes.
      ASSERT_LE(std::abs(exact - quantize(linear)), 0.5 + 0.01) << linear << " of " << largest;
    }
  }
}

TEST(SrgbQuantizer, TakesAnyFloat) {
  const SrgbQuantizer quantize(255);
  EXPECT_EQ(quantize(kNan), 0);
  EXPECT_EQ(quantize(-kInfinity), 0);
  EXPECT_EQ(quantize(-1.0F), 0);
  EXPECT_EQ(quantize(-0.0F), 0);
  EXPECT_EQ(quantize(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(quantize(std::nextafter(1.0F, 0.0F)), 255);
  EXPECT_EQ(quantize(1.0F), 255);
  EXPECT_EQ(quantize(1e30F), 255);
  EXPECT_EQ(quantize(kInfinity), 255);
}

TEST(DisplayFromLinear, IsWithinItsBound) {
  const std::uint32_t end = std::bit_cast<std::uint32_t>(1.0F);
  for (std::uint32_t bits = 0; bits <= end; bits += 331) {
    const float linear = std::bit_cast<float>(bits);
    ASSERT_LE(std::abs(display_from_linear(linear) - srgb_exactly(linear)), kDisplayTolerance) << linear;
  }
}

TEST(DisplayFromLinear, EndsAreExactAndAnythingElseIsClamped) {
  for (const float black : {0.0F, -0.0F, -1.0F, -kInfinity, kNan}) EXPECT_EQ(display_from_linear(black), 0.0F);
  for (const float white : {1.0F, 1.5F, 1e30F, kInfinity})
    EXPECT_NEAR(display_from_linear(white), 1, kDisplayTolerance);
}

/// The kernels, once per instruction set.
class ColorRows : public hwy::TestWithParamTarget {
 protected:
  std::vector<Pixel> random_pixels(std::size_t count) {
    std::vector<Pixel> pixels(count);
    for (Pixel& pixel : pixels)
      for (int c = 0; c < 4; ++c) pixel[c] = random_value();
    return pixels;
  }

  float random_value() {
    static constexpr float kOdd[] = {0,    -0.0F,     1,          std::numeric_limits<float>::denorm_min(), kNan,  -1,
                                     1.5F, kInfinity, -kInfinity, std::numeric_limits<float>::max(),        1e-40F};
    const auto draw = random_();
    if (draw % 16 == 0) return kOdd[draw / 16 % std::size(kOdd)];
    if (draw % 16 < 4) return 1;
    return std::exp2(std::uniform_real_distribution<float>(-16, 0.1F)(random_));
  }

  /// Calls `test(pixels)` for all small widths and a long row.
  template <typename Test>
  void for_rows_of_pixels(const Test& test) {
    for (std::size_t width = 1; width <= 67; ++width) test(random_pixels(width));
    test(random_pixels(5000));
  }

  unsigned seed_ = std::random_device{}();
  testing::ScopedTrace trace_{__FILE__, __LINE__, testing::Message() << "seed " << seed_};
  std::mt19937 random_{seed_};
};
HWY_TARGET_INSTANTIATE_TEST_SUITE_P(ColorRows);

/// Compares the codes of both, and the memory after them.
template <typename Code>
void expect_same_codes(std::span<const Pixel> pixels, int channels) {
  constexpr Code kGuard = 77;
  const std::size_t count = pixels.size() * static_cast<std::size_t>(channels);
  std::vector<Code> actual(count + 1, kGuard);
  std::vector<Code> expected(count + 1, kGuard);
  srgb_codes(pixels, channels, actual.data());
  reference_srgb_codes(pixels, channels, expected.data());
  for (std::size_t i = 0; i <= count; ++i)
    ASSERT_EQ(actual[i], expected[i]) << "code " << i << " of " << count << ", " << channels << " channels";
}

TEST_P(ColorRows, CodesEqualTheReference) {
  expect_same_codes<std::uint8_t>({}, 3);
  for_rows_of_pixels([](std::span<const Pixel> pixels) {
    for (const int channels : {3, 4}) {
      expect_same_codes<std::uint8_t>(pixels, channels);
      expect_same_codes<std::uint16_t>(pixels, channels);
    }
  });
}

TEST_P(ColorRows, CodesAreExactBesideEveryBoundary) {
  for (const int largest : {255, 65535}) {
    std::vector<Pixel> pixels;
    for (int code = 0; code < largest; ++code) {
      const float boundary = linear_from_srgb(static_cast<float>((code + 0.5) / largest));
      const std::uint32_t bits = std::bit_cast<std::uint32_t>(boundary);
      const auto at = [&](std::uint32_t off) { return std::bit_cast<float>(bits + off); };
      pixels.emplace_back(at(0U - 3), at(0U - 2), at(0U - 1), 1.0F);
      pixels.emplace_back(at(0), at(1), at(2), 1.0F);
    }
    if (largest == 255)
      expect_same_codes<std::uint8_t>(pixels, 3);
    else
      expect_same_codes<std::uint16_t>(pixels, 3);
  }
}

TEST_P(ColorRows, CodesAreExactAlongTheScale) {
  // Every 641st float of [0, 1], more than a million: all pieces of the curve, in a mixed order.
  std::vector<Pixel> pixels;
  const std::uint32_t end = std::bit_cast<std::uint32_t>(1.0F);
  for (std::uint32_t bits = 0; bits + 2 * 641 <= end; bits += 3 * 641) {
    pixels.emplace_back(std::bit_cast<float>(bits), std::bit_cast<float>(bits + 641), std::bit_cast<float>(bits + 1282),
                        1.0F);
  }
  expect_same_codes<std::uint8_t>(pixels, 3);
  expect_same_codes<std::uint16_t>(pixels, 3);
}

void expect_same_planes(const DisplayRow& actual, const DisplayRow& expected, int channels, int margin) {
  for (int c = 0; c < channels; ++c) {
    for (std::ptrdiff_t x = -margin; x < static_cast<std::ptrdiff_t>(expected.width()) + margin; ++x) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(actual.plane(c)[x]), std::bit_cast<std::uint32_t>(expected.plane(c)[x]))
          << "plane " << c << " at " << x << " of " << expected.width();
    }
  }
}

TEST_P(ColorRows, DisplayPlanesEqualTheReference) {
  for_rows_of_pixels([](std::span<const Pixel> pixels) {
    for (const bool straight : {false, true}) {
      for (const std::size_t more : {0, 1, 40}) {
        DisplayRow actual(pixels.size() + more);
        DisplayRow expected(pixels.size() + more);
        to_display(pixels, straight, actual);
        reference_to_display(pixels, straight, expected);
        expect_same_planes(actual, expected, 4, 1);
      }
    }
  });
}

TEST_P(ColorRows, MeansEqualTheReference) {
  for_rows_of_pixels([this](std::span<const Pixel> pixels) {
    DisplayRow upper(pixels.size());
    DisplayRow lower(pixels.size());
    reference_to_display(pixels, true, upper);
    reference_to_display(random_pixels(pixels.size()), true, lower);
    for (const int across : {1, 2}) {
      const std::size_t width =
          (pixels.size() + static_cast<std::size_t>(across) - 1) / static_cast<std::size_t>(across);
      DisplayRow actual(width);
      DisplayRow expected(width);
      mean_row(upper, lower, across, actual);
      reference_mean_row(upper, lower, across, expected);
      expect_same_planes(actual, expected, 3, 0);
    }
  });
}

template <typename Code>
void expect_same_sums(const DisplayRow& row, const CodeWeights& weights) {
  constexpr Code kGuard = 77;
  std::vector<Code> actual(row.width() + 1, kGuard);
  std::vector<Code> expected(row.width() + 1, kGuard);
  weighted_codes(row, weights, actual.data());
  reference_weighted_codes(row, weights, expected.data());
  EXPECT_EQ(actual, expected) << row.width();
}

TEST_P(ColorRows, WeightedCodesEqualTheReference) {
  for_rows_of_pixels([](std::span<const Pixel> pixels) {
    DisplayRow row(pixels.size());
    reference_to_display(pixels, false, row);
    expect_same_sums<std::uint8_t>(row, {16, {46.56F, 156.63F, 15.81F, 0}});
    expect_same_sums<std::uint8_t>(row, {128, {-25.66F, -86.34F, 112, 0}});
    expect_same_sums<std::uint8_t>(row, {0, {0, 0, 0, 255}});
    expect_same_sums<std::uint16_t>(row, {512, {448, -406.9F, -41.1F, 0}});
    expect_same_sums<std::uint16_t>(row, {0, {0, 0, 0, 65535}});
  });
}

}  // namespace
}  // namespace morphkit::warp
