#include <string>

#include <gtest/gtest.h>

#include "morph/json/json.h"
#include "morph/project/codecs.h"
#include "morph/project/project.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::Bad;
using test::expect_bad;
using test::with_shape;

TEST(Timing, AnEasingThatStartsLateFillsTheRest) {
  const auto shape = parse(with_shape(R"({"ease": "sine", "delay": 0.1})"), "").pace.shape;
  EXPECT_EQ(shape, (motion::Timing{motion::SineEase{}, 0.1, 0.9}));
  EXPECT_EQ(motion::progress(*shape, 1), 1);
}

TEST(Timing, IsWrittenByItsNameIfThatSaysAll) {
  const auto written = [](const motion::Timing& timing) {
    return json::write(Codec<motion::Timing>::write(timing, {}, false), "");
  };
  const auto laid_out = [](const char* text) { return json::write(json::parse(text, ""), ""); };
  EXPECT_EQ(written({motion::SineEase{}, 0, 1}), laid_out(R"("sine")"));
  EXPECT_EQ(written({motion::CubicBezierEase{0.42, 0, 1, 1}, 0, 1}), laid_out(R"("ease-in")"));
  EXPECT_EQ(written({motion::StepEase{0.25}, 0, 1}), laid_out(R"({"ease": "step", "at": 0.25})"));
  EXPECT_EQ(written({motion::LinearEase{}, 0.25, 0.75}), laid_out(R"({"ease": "linear", "delay": 0.25})"));
  EXPECT_EQ(written({motion::KeysEase{{{0, 0, {}}, {1, 1, 0.5}}}, 0, 1}),
            laid_out(R"({"ease": "keys", "keys": [[0, 0], [1, 1, 0.5]]})"));
}

TEST(Timing, EveryEasingIsNamedByItsOwnWord) {
  for (const auto& [word, easing] : Words<motion::Easing>::kTable) {
    if (word == "cubic-bezier") continue;  // without handles it is "ease"
    EXPECT_EQ(word_of(easing), word);
  }
}

TEST(Timing, WrongOnesNameThePlace) {
  const Bad table[] = {
      {with_shape(R"({"delay": 0.5, "duration": 0.6})"), "/transition/shape", "at most 1"},
      {with_shape(R"({"ease": "parabolic", "t1": 0.8, "t2": 0.2})"), "/transition/shape", "t1 <= t2"},
      {with_shape(R"({"ease": "keys", "keys": [[0, 0], [0.5, 1], [0.5, 1], [1, 1]]})"), "/transition/shape", ""},
  };
  for (const Bad& bad : table) expect_bad(bad);
}

}  // namespace
}  // namespace morphkit::project
