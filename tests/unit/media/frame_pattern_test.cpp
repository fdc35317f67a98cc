#include "morph/media/frame_pattern.h"

#include <climits>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"

namespace morphkit::media {
namespace {

std::string name(const std::string& pattern, int frame) {
  return FramePattern(pattern)(frame).string();
}

std::string refusal(const std::string& pattern) {
  try {
    const FramePattern parsed(pattern);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported);
    EXPECT_EQ(error.place(), pattern);
    return error.message();
  }
  ADD_FAILURE() << pattern << " was accepted";
  return {};
}

TEST(FramePattern, PutsTheNumberInItsPlace) {
  EXPECT_EQ(name("frame.%d.png", 7), "frame.7.png");
  EXPECT_EQ(name("frame.%04d.png", 7), "frame.0007.png");
  EXPECT_EQ(name("frame.####.png", 7), "frame.0007.png");
  EXPECT_EQ(name("#.png", 12), "12.png");
  EXPECT_EQ(name("%02d", 345), "345");
  EXPECT_EQ(name("out/a_###_b.tif", 1001), "out/a_1001_b.tif");
  EXPECT_EQ(name("%0d.png", 3), "3.png");
  EXPECT_EQ(name("/x/%03d.exr", 0), "/x/000.exr");
}

TEST(FramePattern, AgreesWithPrintfForAnyNumber) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::vector<int> frames = {0, 1, -1, 9999, 10000, INT_MAX, INT_MIN};
  for (int i = 0; i < 200; ++i) frames.push_back(static_cast<int>(random()) >> (random() % 32));
  for (const int frame : frames) {
    for (int width = 1; width <= 12; ++width) {
      char expected[64];
      std::snprintf(expected, sizeof expected, "f%0*d.png", width, frame);
      EXPECT_EQ(name(std::string("f").append(width, '#').append(".png"), frame), expected);
      EXPECT_EQ(name(std::string("f%0").append(std::to_string(width)).append("d.png"), frame), expected);
    }
  }
}

TEST(FramePattern, DoublePercentIsAPercentSign) {
  EXPECT_EQ(name("100%%.%d.png", 5), "100%.5.png");
  EXPECT_EQ(name("%%%d.png", 5), "%5.png");
  EXPECT_EQ(name("%%d.%d.png", 5), "%d.5.png");
  EXPECT_FALSE(FramePattern::matches("100%%d.png"));
}

TEST(FramePattern, FoldersAreTakenLiterally) {
  EXPECT_EQ(name("take#1/%d%%/f.%d.png", 2), "take#1/%d%%/f.2.png");
  EXPECT_FALSE(FramePattern::matches("take.####/frame.png"));
  EXPECT_NE(refusal("take.####/frame.png").find("no place"), std::string::npos);
}

TEST(FramePattern, MatchesNamesWithAPlace) {
  for (const char* yes : {"%d", "a.%04d.png", "a.#.png", "####", "%d.%d.png", "#%4x"})
    EXPECT_TRUE(FramePattern::matches(yes)) << yes;
  for (const char* no : {"", "a.png", "100%.png", "%%d", "%x.png", "%4d.png", "d.png", "%", "%0"})
    EXPECT_FALSE(FramePattern::matches(no)) << no;
}

TEST(FramePattern, KnowsTheNamesOfItsFrames) {
  const FramePattern pattern("out/part.%04d.png");
  for (const char* yes : {"part.0001.png", "part.12345.png", "part.-001.png"}) EXPECT_TRUE(pattern.names(yes)) << yes;
  for (const char* no : {"part.1.png", "part.00001.png", "part..png", "part.png", "part.0001.tif", "apart.0001.png",
                         "part.00x1.png", "part.99999999999.png"})
    EXPECT_FALSE(pattern.names(no)) << no;
}

TEST(FramePattern, RefusesInvalidPlaces) {
  EXPECT_NE(refusal("frame.png").find("no place for the frame number"), std::string::npos);
  EXPECT_NE(refusal("frame.png").find("frame.%04d.png"), std::string::npos);
  EXPECT_NE(refusal("").find("no place"), std::string::npos);
  EXPECT_NE(refusal("%d.%d.png").find("more than one"), std::string::npos);
  EXPECT_NE(refusal("##_##.png").find("more than one"), std::string::npos);
  EXPECT_NE(refusal("%04d.###.png").find("more than one"), std::string::npos);
  EXPECT_NE(refusal("%4d.png").find("'%4d'"), std::string::npos);
  EXPECT_NE(refusal("50%.%d.png").find("%%"), std::string::npos);
  EXPECT_NE(refusal("%s.png").find("'%s.'"), std::string::npos);
  EXPECT_NE(refusal("%d.%").find("'%'"), std::string::npos);
  EXPECT_NE(refusal("%099d.png").find("32 digits"), std::string::npos);
  EXPECT_NE(refusal("%0999999999999999999999d.png").find("32 digits"), std::string::npos);
  EXPECT_NE(refusal(std::string(33, '#') + ".png").find("32 digits"), std::string::npos);
}

}  // namespace
}  // namespace morphkit::media
