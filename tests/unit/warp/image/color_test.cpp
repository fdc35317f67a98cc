#include "warp/image/color.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace morphkit::warp {
namespace {

// The standard, in double; the two pieces switch at their true intersection.
double exact_linear(double srgb) {
  const double magnitude = std::abs(srgb);
  const double linear =
      magnitude <= 0.0404482362771082 ? magnitude / 12.92 : std::pow((magnitude + 0.055) / 1.055, 2.4);
  return std::copysign(linear, srgb);
}

double exact_srgb(double linear) {
  const double magnitude = std::abs(linear);
  const double srgb =
      magnitude <= 0.0031306684425006 ? magnitude * 12.92 : 1.055 * std::pow(magnitude, 1 / 2.4) - 0.055;
  return std::copysign(srgb, linear);
}

float ulp(float value) {
  const float magnitude = std::fabs(value);
  return std::nextafter(magnitude, std::numeric_limits<float>::infinity()) - magnitude;
}

// Positive floats spread evenly over the logarithm, from denormals to the largest.
template <typename Fn>
void for_floats(std::uint32_t stride, const Fn& fn) {
  const std::uint32_t end = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
  for (std::uint32_t bits = 0; bits < end; bits += stride) fn(std::bit_cast<float>(bits));
}

TEST(Color, EveryCodeSurvivesTheRoundTrip) {
  for (const int top : {255, 65535}) {
    for (int code = 0; code <= top; ++code) {
      const float value = static_cast<float>(code) / static_cast<float>(top);
      const float back = srgb_from_linear(linear_from_srgb(value));
      ASSERT_EQ(std::lround(back * static_cast<float>(top)), code) << "of " << top;
    }
  }
}

TEST(Color, EndsAreExact) {
  EXPECT_EQ(linear_from_srgb(0.0F), 0.0F);
  EXPECT_EQ(linear_from_srgb(1.0F), 1.0F);
  EXPECT_EQ(srgb_from_linear(0.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(1.0F), 1.0F);
}

TEST(Color, WithinOneUlpOfTheStandard) {
  for_floats(997, [](float value) {
    // Beyond this the linear value overflows float.
    if (value < 1e16F) {
      const float linear = linear_from_srgb(value);
      ASSERT_LE(std::abs(linear - exact_linear(value)), ulp(linear)) << value;
    }
    const float srgb = srgb_from_linear(value);
    ASSERT_LE(std::abs(srgb - exact_srgb(value)), ulp(srgb)) << value;
  });
}

TEST(Color, DiffersFromTheStandardByTheStatedAmountAtMost) {
  const double by_standard = 1.055 * std::pow(0.0031307, 1 / 2.4) - 0.055;
  EXPECT_NEAR(srgb_from_linear(0.0031307F), by_standard, 3e-8);
  EXPECT_NEAR(srgb_from_linear(0.0031308F), 0.0031308 * 12.92, 3e-8);
}

TEST(Color, MonotoneBetweenNeighbouringFloatsNearTheBreak) {
  // Every float of [1/1024, 2): it contains the break and most knots of the tables.
  const std::uint32_t begin = std::bit_cast<std::uint32_t>(1.0F / 1024);
  const std::uint32_t end = std::bit_cast<std::uint32_t>(2.0F);
  float last_linear = 0;
  float last_srgb = 0;
  for (std::uint32_t bits = begin; bits < end; ++bits) {
    const float value = std::bit_cast<float>(bits);
    const float linear = linear_from_srgb(value);
    const float srgb = srgb_from_linear(value);
    if (linear < last_linear || srgb < last_srgb) FAIL() << "falls at " << value;
    last_linear = linear;
    last_srgb = srgb;
  }
}

TEST(Color, MonotoneOverAllMagnitudes) {
  float last_linear = 0;
  float last_srgb = 0;
  for_floats(499, [&](float value) {
    const float linear = linear_from_srgb(value);
    const float srgb = srgb_from_linear(value);
    ASSERT_GE(linear, last_linear) << value;
    ASSERT_GE(srgb, last_srgb) << value;
    last_linear = linear;
    last_srgb = srgb;
  });
}

TEST(Color, OddSymmetry) {
  for_floats(100003, [](float value) {
    ASSERT_EQ(linear_from_srgb(-value), -linear_from_srgb(value)) << value;
    ASSERT_EQ(srgb_from_linear(-value), -srgb_from_linear(value)) << value;
  });
  EXPECT_TRUE(std::signbit(linear_from_srgb(-0.0F)));
  EXPECT_TRUE(std::signbit(srgb_from_linear(-0.0F)));
}

TEST(Color, NonFiniteStays) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(linear_from_srgb(kInfinity), kInfinity);
  EXPECT_EQ(linear_from_srgb(-kInfinity), -kInfinity);
  EXPECT_EQ(srgb_from_linear(kInfinity), kInfinity);
  EXPECT_EQ(srgb_from_linear(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(linear_from_srgb(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(srgb_from_linear(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Color, SpansEqualSingleValues) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::normal_distribution<float> normal(0.3F, 2.0F);
  for (std::size_t n = 0; n <= 67; ++n) {
    std::vector<float> values(n);
    for (float& value : values) value = normal(random);
    std::vector<float> linear = values;
    std::vector<float> srgb = values;
    linear_from_srgb(linear);
    srgb_from_linear(srgb);
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(linear[i], linear_from_srgb(values[i])) << values[i];
      ASSERT_EQ(srgb[i], srgb_from_linear(values[i])) << values[i];
    }
  }
}

}  // namespace
}  // namespace morphkit::warp
