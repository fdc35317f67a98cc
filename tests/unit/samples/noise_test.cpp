// Noise and dice stay in their range, and are the same everywhere.

#include "samples/noise.h"

#include <gtest/gtest.h>

namespace morphkit::samples {
namespace {

TEST(Noise, StaysInRangeAndIsContinuous) {
  Dice dice(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const cv::Point2f p(dice.between(-300, 300), dice.between(-300, 300));
    const float here = value_noise(p, 7);
    ASSERT_GE(here, 0);
    ASSERT_LE(here, 1);
    // The fade's steepest slope is 15/8 per unit in each direction.
    ASSERT_NEAR(value_noise(p + cv::Point2f(0.01F, 0), 7), here, 0.01 * 15 / 8 + 1e-4);
    const float sum = fractal_noise(p, 4, 7);
    ASSERT_GE(sum, 0);
    ASSERT_LE(sum, 1);
  }
}

TEST(Dice, FillsItsRangeEvenly) {
  Dice dice(3);
  int counts[10] = {};
  for (int throws = 0; throws < 10000; ++throws) {
    const float x = dice.between(-2, 3);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 3);
    ++counts[static_cast<int>((x + 2) * 2)];
  }
  // Five standard deviations of a binomial count, sqrt(10000 * 0.1 * 0.9) = 30; the stream is fixed.
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
}

TEST(Hash, IsTheSameOnEveryMachine) {
  // The pictures and the golden frames depend on these values.
  EXPECT_EQ(hash(0, 0, 0), 1565893538U);
  EXPECT_EQ(hash(-5, 17, 3), 1327660541U);
}

}  // namespace
}  // namespace morphkit::samples
