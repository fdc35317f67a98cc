#include "base/monotone.h"

#include <gtest/gtest.h>

namespace morphkit::test {
namespace {

TEST(Monotone, AStraightLineKeepsItsSlope) {
  EXPECT_EQ(monotone_slope({2, 0.75}, {5, 0.75}), 0.75);
  EXPECT_EQ(monotone_end_slope({2, 0.75}, {5, 0.75}), 0.75);
}

TEST(Monotone, ALocalExtremeIsFlat) {
  EXPECT_EQ(monotone_slope({1, 2}, {1, -3}), 0);
  EXPECT_EQ(monotone_slope({1, 0}, {1, 3}), 0);
}

TEST(Monotone, IsTheSlopeOfTheParabolaThroughThreeKnots) {
  // y = x^2 at 0, 1, 3
  EXPECT_DOUBLE_EQ(monotone_slope({1, 1}, {2, 4}), 2);
  EXPECT_DOUBLE_EQ(monotone_end_slope({2, 4}, {1, 1}), 6);
}

TEST(Monotone, StaysWithinThreeTimesTheNearerSecant) {
  EXPECT_EQ(monotone_slope({100, 1}, {1, 50}), 3);
  EXPECT_EQ(monotone_slope({100, -1}, {1, -50}), -3);
  EXPECT_EQ(monotone_end_slope({1, 1}, {1, 10}), 0);
}

}  // namespace
}  // namespace morphkit::test
