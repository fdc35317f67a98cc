#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "morph/motion/easing.h"

namespace morphkit::motion {
namespace {

KeysEase random_keys(unsigned seed, bool rising) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t count = 2 + random() % 7;
  std::vector<double> times = {0, 1}, distances;
  while (times.size() < count) times.push_back(unit(random));
  for (std::size_t i = 0; i < count; ++i) distances.push_back(random() % 4 == 0 ? 0.5 : unit(random));
  std::ranges::sort(times);
  if (rising) std::ranges::sort(distances);
  KeysEase result;
  for (std::size_t i = 0; i < count; ++i) result.keys.push_back({times[i], distances[i], {}});
  return result;
}

double slope(const KeysEase& ease_keys, double t, double h) {
  return (ease(ease_keys, t + h) - ease(ease_keys, t)) / h;
}

TEST(KeysEase, PassesThroughItsKeysExactlyAndStaysBetweenNeighbours) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const KeysEase e = random_keys(seed, false);
    ASSERT_FALSE(problem(e));
    for (std::size_t i = 0; i < e.keys.size(); ++i) ASSERT_EQ(ease(e, e.keys[i].t), e.keys[i].s);
    for (std::size_t i = 0; i + 1 < e.keys.size(); ++i) {
      const auto [low, high] = std::minmax(e.keys[i].s, e.keys[i + 1].s);
      for (int k = 0; k <= 50; ++k) {
        const double s = ease(e, e.keys[i].t + (e.keys[i + 1].t - e.keys[i].t) * k / 50);
        ASSERT_GE(s, low - 1e-15);
        ASSERT_LE(s, high + 1e-15);
      }
    }
  }
}

TEST(KeysEase, RisesWhereverItsKeysRise) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const KeysEase e = random_keys(seed, true);
    for (int i = 1; i <= 1000; ++i) ASSERT_GE(ease(e, i / 1000.0), ease(e, (i - 1) / 1000.0) - 1e-15) << i;
  }
}

TEST(KeysEase, SlopeIsContinuousAtKeys) {
  const KeysEase e{{{0, 0, {}}, {0.2, 0.3, {}}, {0.5, 0.4, {}}, {0.9, 0.8, {}}, {1, 1, {}}}};
  for (double t : {0.2, 0.5, 0.9}) EXPECT_NEAR(slope(e, t, 1e-6), slope(e, t, -1e-6), 1e-3) << t;
}

TEST(KeysEase, KeepsGivenSpeeds) {
  // 5 is steeper than any monotone choice here, -1 runs backwards: the author asked for both.
  const KeysEase e{{{0, 0, 0.0}, {0.5, 0.5, 5.0}, {1, 1, -1.0}}};
  EXPECT_NEAR(slope(e, 0, 1e-7), 0, 1e-5);
  EXPECT_NEAR(slope(e, 0.5, -1e-7), 5, 1e-5);
  EXPECT_NEAR(slope(e, 0.5, 1e-7), 5, 1e-5);
  EXPECT_NEAR(slope(e, 1, -1e-7), -1, 1e-5);
}

TEST(KeysEase, KeysOnALineGiveTheLine) {
  const KeysEase two{{{0, 0, {}}, {1, 1, {}}}}, four{{{0, 0, {}}, {0.1, 0.1, {}}, {0.7, 0.7, {}}, {1, 1, {}}}};
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(ease(two, i / 100.0), i / 100.0, 1e-15);
    EXPECT_NEAR(ease(four, i / 100.0), i / 100.0, 1e-15);
  }
}

TEST(KeysEase, GivesItsOwnEndValues) {
  const KeysEase e{{{0, 0.25, {}}, {1, 0.75, {}}}};
  EXPECT_EQ(ease(e, -1), 0.25);
  EXPECT_EQ(ease(e, 2), 0.75);
}

TEST(KeysEase, ProblemsAreExplained) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem(KeysEase{}), "distance keys need at least two keys, one at time 0 and one at time 1");
  EXPECT_EQ(problem(KeysEase{{{0, 0, {}}, {0.9, 1, {}}}}), "the first key must be at time 0 and the last at time 1");
  EXPECT_EQ(problem(KeysEase{{{0, 0, {}}, {0.5, 0, {}}, {0.5, 1, {}}, {1, 1, {}}}}),
            "the times of keys must rise strictly");
  for (const KeysEase::Key& bad : {KeysEase::Key{nan, 0, {}}, {0.5, nan, {}}, {0.5, 0, nan}}) {
    EXPECT_EQ(problem(KeysEase{{{0, 0, {}}, bad, {1, 1, {}}}}),
              "times, distances and speeds of keys must be finite numbers");
  }
}

}  // namespace
}  // namespace morphkit::motion
