#include "morph/project/clock.h"

#include <gtest/gtest.h>

namespace morphkit::project {
namespace {

Output output(int start, int frames, Rate fps = {24, 1}) {
  Output output;
  output.start = start;
  output.frames = frames;
  output.fps = fps;
  return output;
}

TEST(Clock, GoesFromTheFirstFrameToTheLast) {
  const Clock clock(output(101, 5));
  EXPECT_EQ(clock.first(), 101);
  EXPECT_EQ(clock.last(), 105);
  EXPECT_EQ(clock.at_frame(101).t, 0);
  EXPECT_EQ(clock.at_frame(103).t, 0.5);
  EXPECT_EQ(clock.at_frame(103.5).t, 0.625);
  EXPECT_EQ(clock.at_frame(105).t, 1);
  EXPECT_EQ(clock.at(0.5).frame, 103);
}

TEST(Clock, StaysWithinTheMorph) {
  const Clock clock(output(1, 3));
  EXPECT_EQ(clock.at_frame(-5).t, 0);
  EXPECT_EQ(clock.at_frame(99).t, 1);
  EXPECT_EQ(clock.stepped(0.5, 5).t, 1);
  EXPECT_EQ(clock.stepped(0.5, -5).t, 0);
}

TEST(Clock, OneFrameIsTheBeginning) {
  const Clock clock(output(7, 1));
  EXPECT_EQ(clock.last(), 7);
  EXPECT_EQ(clock.at_frame(7).t, 0);
  EXPECT_EQ(clock.at(1).frame, 7);
}

TEST(Clock, StepsFromTheNearestFrame) {
  const Clock clock(output(1, 5));
  EXPECT_EQ(clock.stepped(0.3, 1).t, 0.5);
  EXPECT_EQ(clock.stepped(0.3, 1).frame, 3);
  EXPECT_EQ(clock.stepped(0.3, 0).t, 0.25);
}

TEST(Clock, CountsSecondsByTheExactRate) {
  const Clock clock(output(1, 31, {30000, 1001}));
  EXPECT_DOUBLE_EQ(clock.duration_s(), 31 * 1001.0 / 30000);
  EXPECT_DOUBLE_EQ(clock.span_s(), 1.001);
  EXPECT_DOUBLE_EQ(Clock(output(1, 1)).span_s(), 1.0 / 24) << "playing one frame takes some time, too";
}

TEST(Clock, EveryFrameComesBackFromItsProgress) {
  for (const int frames : {2, 3, 24, 1000}) {
    const Clock clock(output(1001, frames));
    for (int frame = clock.first(); frame <= clock.last(); ++frame)
      ASSERT_NEAR(clock.at(clock.at_frame(frame).t).frame, frame, 1e-9);
  }
}

}  // namespace
}  // namespace morphkit::project
