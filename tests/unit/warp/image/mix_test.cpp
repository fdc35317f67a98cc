// Mixed rows: the kernel against its reference on every instruction set that this machine runs.

#include "warp/image/mix.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/warp/image/same_pixels.h"

namespace morphkit::warp {
namespace {

using test::same_pixels;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using Pixels = std::vector<Pixel>;
using Weights = std::vector<float>;

// The parameter is the instruction set.
class MixRow : public hwy::TestWithParamTarget {};

HWY_TARGET_INSTANTIATE_TEST_SUITE_P(MixRow);

Pixels random_pixels(std::size_t count, std::mt19937& random) {
  constexpr std::array kHostile = {kNan, kInfinity, -kInfinity, 1e-44F, 3.4e38F, -0.0F};
  std::uniform_real_distribution<float> value(-2, 2);
  std::uniform_int_distribution<std::size_t> kind(0, 60);
  Pixels result(count);
  for (Pixel& pixel : result) {
    for (int c = 0; c < 4; ++c) {
      const std::size_t k = kind(random);
      pixel[c] = k < kHostile.size() ? kHostile[k] : value(random);
    }
  }
  return result;
}

Weights random_weights(std::size_t count, std::mt19937& random) {
  constexpr std::array kSpecial = {0.0F, 1.0F, -0.0F, -0.5F, 1.5F, kNan, kInfinity, 1e-44F};
  std::uniform_real_distribution<float> value(0, 1);
  std::uniform_int_distribution<std::size_t> kind(0, 15);
  Weights result(count);
  for (float& weight : result) {
    const std::size_t k = kind(random);
    weight = k < kSpecial.size() ? kSpecial[k] : value(random);
  }
  return result;
}

TEST_P(MixRow, EqualsTheReference) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const std::size_t count = seed % 68;
    const Pixels a = random_pixels(count + 1, random);  // one more that must not change
    const Pixels b = random_pixels(count, random);
    for (const Weights& weights : {random_weights(count, random), random_weights(1, random)}) {
      Pixels fast = a;
      Pixels plain = a;
      mix_row(std::span(fast).first(count), b, weights);
      reference_mix_row(std::span(plain).first(count), b, weights);
      ASSERT_TRUE(same_pixels(fast, plain));
      ASSERT_TRUE(same_pixels({fast.back()}, {a.back()}));
    }
  }
}

TEST_P(MixRow, EndsAreTheRowsBitForBit) {
  std::mt19937 random(3);
  for (std::size_t count = 1; count <= 67; ++count) {
    const Pixels a = random_pixels(count, random);
    const Pixels b = random_pixels(count, random);
    for (const bool single : {false, true}) {
      Pixels first = a;
      Pixels second = a;
      mix_row(first, b, Weights(single ? 1 : count, 0.0F));
      mix_row(second, b, Weights(single ? 1 : count, 1.0F));
      ASSERT_EQ(std::memcmp(first.data(), a.data(), count * sizeof(Pixel)), 0);
      ASSERT_EQ(std::memcmp(second.data(), b.data(), count * sizeof(Pixel)), 0);
    }
  }
}

TEST_P(MixRow, OneWeightIsThatWeightForEach) {
  std::mt19937 random(4);
  for (std::size_t count = 2; count <= 67; ++count) {
    const Pixels b = random_pixels(count, random);
    Pixels one = random_pixels(count, random);
    Pixels each = one;
    mix_row(one, b, Weights(1, 0.3F));
    mix_row(each, b, Weights(count, 0.3F));
    ASSERT_TRUE(same_pixels(one, each));
  }
}

TEST_P(MixRow, MixesByWeight) {
  Pixels row{{1, 0, 0, 1}, {8, 4, 2, 1}};
  mix_row(row, Pixels{{0, 0, 1, 0.5F}, {0, 0, 0, 0}}, Weights{0.25F, 0.5F});
  EXPECT_EQ(row[0], Pixel(0.75F, 0, 0.25F, 0.875F));
  EXPECT_EQ(row[1], Pixel(4, 2, 1, 0.5F));
}

}  // namespace
}  // namespace morphkit::warp
