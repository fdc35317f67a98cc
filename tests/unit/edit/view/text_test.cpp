#include "cli/edit/view/text.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace morphkit::edit {
namespace {

constexpr int kHeight = 14;

TEST(Type, LongerTextIsWider) {
  const Type type;
  EXPECT_EQ(type.width("", kHeight), 0);
  EXPECT_GT(type.width("mm", kHeight), type.width("m", kHeight));
  EXPECT_GT(type.width("m", 2 * kHeight), type.width("m", kHeight));
}

TEST(Type, FittedTextIsWholeOrCutAtACharacter) {
  const Type type;
  // Wider than the sign for a broken character, so that a cut amid one would be the longest that fits.
  const std::string text = "left eye \u01c4\u01c4\u01c4\u01c4\u01c4\u01c4";
  const int all = type.width(text, kHeight);
  EXPECT_EQ(type.fitted(text, kHeight, all), text);
  const std::string ellipsis = "\u2026";
  for (int room = all - 1; room > all / 2; --room) {
    const std::string cut = type.fitted(text, kHeight, room);
    ASSERT_TRUE(cut.ends_with(ellipsis)) << cut;
    EXPECT_LE(type.width(cut, kHeight), room);
    const std::size_t kept = cut.size() - ellipsis.size();
    ASSERT_LT(kept, text.size());
    EXPECT_EQ(cut.substr(0, kept), text.substr(0, kept));
    EXPECT_NE(static_cast<unsigned char>(text[kept]) & 0xC0, 0x80) << "amid a character: " << cut;
  }
}

TEST(Type, DrawsInItsColourOnItsLineAndNotBeyondThePicture) {
  const Type type;
  constexpr int kLarge = 40;  // strokes of several px
  cv::Mat3b picture(80, 200, cv::Vec3b(0, 0, 0));
  type.draw(picture, "HHHHHHHHHHHHHHHHHHHHHHHH", {10, 60}, kLarge, {10, 20, 200});
  EXPECT_NE(std::ranges::find(picture, cv::Vec3b(10, 20, 200)), picture.end());
  const auto is_blank = [](const cv::Mat& part) { return cv::countNonZero(part.clone().reshape(1)) == 0; };
  EXPECT_TRUE(is_blank(picture.rowRange(0, 60 - kLarge - 4))) << "above the line";
  EXPECT_TRUE(is_blank(picture.rowRange(64, 80))) << "below it";
  EXPECT_TRUE(is_blank(picture.colRange(0, 8))) << "left of its start";
}

}  // namespace
}  // namespace morphkit::edit
