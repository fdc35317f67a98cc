#include "cli/arguments.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "cli/exit_code.h"
#include "tests/support/errors.h"

namespace morphkit::cli {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_size(text, "--size");
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "";
}

TEST(ParseSize, IsWidthAndHeight) {
  EXPECT_EQ(parse_size("1280x720", "--size"), cv::Size(1280, 720));
  EXPECT_EQ(parse_size("1x65536", "--size"), cv::Size(1, 65536));
}

TEST(ParseSize, RefusesWhatIsNoneAndNamesTheOption) {
  for (const char* text : {"", "x", "1280", "1280x", "x720", "0x720", "-1x720", "12.5x7", "1280X720", "1x2x3", "1 x 2"})
    EXPECT_TRUE(test::contains(refusal(text), "is no size; write WIDTHxHEIGHT")) << text;
  EXPECT_TRUE(test::contains(refusal("x"), "--size"));
}

TEST(ParseSize, RefusesMoreThanAProjectMayAskFor) {
  for (const char* text : {"65537x1", "1x65537", "65536x65536"})
    EXPECT_TRUE(test::contains(refusal(text), "is too large")) << text;
}

TEST(RequireMoment, LiesInTheMorph) {
  for (const double t : {0.0, 0.5, 1.0}) EXPECT_NO_THROW(require_moment(t));
  for (const double t : {-0.001, 1.001, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(require_moment(t), ArgumentError) << t;
}

}  // namespace
}  // namespace morphkit::cli
