#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "morph/project/codecs.h"
#include "morph/project/project.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::Bad;
using test::expect_bad;
using test::with_output;

TEST(OutputValues, FrameRates) {
  const auto rate = [](const std::string& fps) { return parse(with_output("\"fps\": " + fps), "").output.fps; };
  EXPECT_EQ(rate("25"), (Rate{25, 1}));
  EXPECT_EQ(rate("25.0"), (Rate{25, 1}));
  EXPECT_EQ(rate("\"25\""), (Rate{25, 1}));
  EXPECT_EQ(rate("\"25/2\""), (Rate{25, 2}));
  EXPECT_EQ(rate("\"30000/1001\""), (Rate{30000, 1001}));
  EXPECT_EQ(rate("23.976"), (Rate{24000, 1001}));
  EXPECT_EQ(rate("29.97"), (Rate{30000, 1001}));
  EXPECT_EQ(rate("59.94"), (Rate{60000, 1001}));
}

TEST(OutputValues, FrameRatesAsPeopleTypeThem) {
  EXPECT_EQ(parse_rate("25"), (Rate{25, 1}));
  EXPECT_EQ(parse_rate("25/2"), (Rate{25, 2}));
  EXPECT_EQ(parse_rate("23.976"), (Rate{24000, 1001}));
  EXPECT_EQ(parse_rate("29.97"), (Rate{30000, 1001}));
  for (const char* text : {"", "fast", "12.5", "0", "-24", "24/0", "1001", "24 ", "24/1/1", "1e9", "nan"})
    EXPECT_FALSE(parse_rate(text)) << text;
}

TEST(OutputValues, Backgrounds) {
  const auto background = [](const std::string& text) {
    return parse(with_output("\"background\": " + text), "").output.background;
  };
  EXPECT_EQ(background("\"transparent\""), Background(Color{0, 0, 0, 0}));
  EXPECT_EQ(background("\"black\""), Background(Color{0, 0, 0, 1}));
  EXPECT_EQ(background("\"#ff000080\""), Background(Color{1, 0, 0, 128 / 255.0}));
  EXPECT_EQ(background("\"#00Ff33\""), Background(Color{0, 1, 0.2, 1}));
  EXPECT_EQ(background("[0.1, 0.2, 0.3, 0.4]"), Background(Color{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(background("{\"image\": \"sky.png\"}"), Background(std::filesystem::path("sky.png")));
}

TEST(OutputValues, WrongFrameRatesNameThePlace) {
  const Bad table[] = {
      {with_output(R"("fps": "1000000/3")"), "/output/fps", "at most 1000 frames per second"},
      {with_output(R"("fps": "24/0")"), "/output/fps", "a frame rate such as"},
  };
  for (const Bad& bad : table) expect_bad(bad);
}

}  // namespace
}  // namespace morphkit::project
