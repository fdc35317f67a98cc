#include "cli/frame_range.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/exit_code.h"

namespace morphkit::cli {
namespace {

using Frames = std::vector<int>;

std::string refusal(const std::string& text, int first = 1, int last = 48) {
  try {
    parse_frame_range(text, first, last);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "";
}

TEST(FrameRange, KnowsEveryForm) {
  EXPECT_EQ(parse_frame_range("7", 1, 48), Frames({7}));
  EXPECT_EQ(parse_frame_range("3-6", 1, 48), Frames({3, 4, 5, 6}));
  EXPECT_EQ(parse_frame_range("1-8x3", 1, 48), Frames({1, 4, 7}));
  EXPECT_EQ(parse_frame_range("46-", 1, 48), Frames({46, 47, 48}));
  EXPECT_EQ(parse_frame_range("40-x4", 1, 48), Frames({40, 44, 48}));
  EXPECT_EQ(parse_frame_range("1,5,9-12", 1, 48), Frames({1, 5, 9, 10, 11, 12}));
  EXPECT_EQ(parse_frame_range("0-1", 0, 1), Frames({0, 1}));
}

TEST(FrameRange, SortsAndKeepsEachFrameOnce) {
  EXPECT_EQ(parse_frame_range("9,3-5,4-6,3", 1, 48), Frames({3, 4, 5, 6, 9}));
}

TEST(FrameRange, StrideSharesOfAFarmAddUpToTheWhole) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 engine(seed);
  for (int trial = 0; trial < 50; ++trial) {
    const int last = 1 + static_cast<int>(engine() % 60);
    const int machines = 1 + static_cast<int>(engine() % static_cast<unsigned>(last));
    std::string shares;
    for (int i = 0; i < machines; ++i) {
      if (i > 0) shares += ",";
      shares += std::to_string(1 + i);
      shares += "-x";
      shares += std::to_string(machines);
    }
    EXPECT_EQ(parse_frame_range(shares, 1, last), parse_frame_range("1-", 1, last)) << shares;
  }
}

TEST(FrameRange, RefusesWhatIsNotARange) {
  for (const std::string text : {"", ",", "1,", ",1", "a", "1-b", "-5", "1--5", "1-5x", "1-5y2", "1 - 5", "1.5", "x2",
                                 "1-5x-1", "1-5x2x2", "99999999999"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

TEST(FrameRange, RefusesFramesThatDoNotExistWithoutListingThemFirst) {
  EXPECT_NE(refusal("1-2000000000").find("the frames are 1-48"), std::string::npos);
  EXPECT_NE(refusal("0").find("frame 0 does not exist"), std::string::npos);
  EXPECT_NE(refusal("49-").find("frame 49 does not exist"), std::string::npos);
}

TEST(FrameRange, RefusesBackwardsRangesAndStepZero) {
  EXPECT_NE(refusal("9-3").find("write 3-9"), std::string::npos);
  EXPECT_NE(refusal("1-9x0").find("step"), std::string::npos);
}

}  // namespace
}  // namespace morphkit::cli
