#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/set_value.h"
#include "tests/support/errors.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

std::string refusal(const std::string& path, const std::string& value) {
  Project project = parse(test::kFull, "pair.json");
  const Project before = project;
  try {
    set_value(project, path, value);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_TRUE(same_document(project, before));
    return error.place() + ": " + error.message();
  }
  return "accepted";
}

TEST(SetValue, SetsNumbersWordsAndPlaces) {
  Project project = parse(test::kFull, "pair.json");
  set_value(project, "warp.filter", "lanczos");
  set_value(project, "warp.b", "1.25");
  set_value(project, "output.size", "[640, 480]");
  set_value(project, "output.fps", "29.97");
  set_value(project, "output.fps", "25/2");
  set_value(project, "output.background", "#ff0000");
  set_value(project, "source.image", "other cat.png");
  set_value(project, "features/nose.point.source", "[1, 2.5]");
  set_value(project, "groups/face.transition.shape", "sine");
  set_value(project, "groups/face.transition.shape.delay", "0.5");
  EXPECT_EQ(project.warp.filter, warp::Filter::kLanczos);
  EXPECT_EQ(project.output.size, cv::Size(640, 480));
  EXPECT_EQ(project.output.fps, (Rate{25, 2}));
  EXPECT_EQ(project.output.background, (Background{Color{1, 0, 0, 1}}));
  EXPECT_EQ(project.pull.b, 1.25);
  EXPECT_TRUE(test::contains(to_text(project), R"({"image": "other cat.png")"));
  EXPECT_TRUE(test::contains(to_text(project), R"("source": [1, 2.5])"));
  EXPECT_TRUE(test::contains(to_text(project), R"({"ease": "sine", "delay": 0.5})"));
  EXPECT_EQ(project.file, "pair.json");
  EXPECT_EQ(*project.original, test::kFull);
}

TEST(SetValue, ReachesWhatTheDocumentDoesNotSay) {
  Project project = parse(test::with(""), "pair.json");
  set_value(project, "warp.between", "centre");
  set_value(project, "output.frames", "96");
  EXPECT_EQ(project.output.frames, 96);
  EXPECT_TRUE(test::contains(to_text(project), R"("warp": {"between": "centre"})"));
}

TEST(SetValue, SeveralNeedToFitTogetherInTheEndOnly) {
  Project project = parse(test::with_feature(R"({"id": "x", "curve": {"source": [[0, 0], [9, 0], [9, 9]],
    "destination": [[0, 0], [9, 0], [9, 9]], "spline": "polyline"}})"),
                          "pair.json");
  const Setting open_ended[] = {{"features/x.curve.spline", "bezier"},
                                {"features/x.curve.source", "[[0, 0], [1, 0], [2, 0], [3, 3]]"},
                                {"features/x.curve.destination", "[[0, 0], [1, 0], [2, 0], [3, 3]]"}};
  EXPECT_THROW(set_value(project, open_ended[0].path, open_ended[0].value), Error);
  set_values(project, open_ended);
  EXPECT_EQ(project.features[0].places[kSource].size(), 4U);
}

TEST(SetValue, OneMayContinueAnother) {
  Project project = parse(test::with(""), "pair.json");
  const Setting easing[] = {{"transition.shape", "sine"}, {"transition.shape.delay", "0.5"}};
  set_values(project, easing);
  EXPECT_TRUE(test::contains(to_text(project), R"({"ease": "sine", "delay": 0.5})"));
}

TEST(SetValue, OfSeveralTheLastWinsAndTheWrongOneIsNamed) {
  Project project = parse(test::with(""), "pair.json");
  const Setting twice[] = {{"output.frames", "5"}, {"output.frames", "7"}};
  set_values(project, twice);
  EXPECT_EQ(project.output.frames, 7);
  const Project before = project;
  const Setting wrong[] = {{"output.frames", "9"}, {"warp.b", "9"}, {"output.start", "3"}};
  try {
    set_values(project, wrong);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "warp.b: 9 is out of range; expected 0 to 8");
  }
  EXPECT_TRUE(same_document(project, before));
}

TEST(SetValue, AnUnknownPathNamesTheNearest) {
  EXPECT_EQ(refusal("warp.fitler", "area"), "warp.fitler: unknown key \"fitler\"; did you mean \"filter\"?");
  EXPECT_EQ(refusal("wrap.filter", "area"), "wrap.filter: unknown key \"wrap\"; did you mean \"warp\"?");
  EXPECT_EQ(refusal("features/noes.point.source", "[1, 2]"),
            "features/noes.point.source: nothing here has the id \"noes\"; did you mean \"nose\"?");
  EXPECT_TRUE(test::contains(refusal("", "1"), "unknown key"));
  EXPECT_TRUE(test::contains(refusal("warp.b.c", "1"), "there is no such key"));
}

TEST(SetValue, AWrongValueGetsTheMessageOfAFile) {
  EXPECT_EQ(refusal("warp.b", "9"), "warp.b: 9 is out of range; expected 0 to 8");
  EXPECT_EQ(refusal("warp.filter", "lanzcos"), "warp.filter: unknown filter \"lanzcos\"; did you mean \"lanczos\"?");
  EXPECT_EQ(refusal("output.frames", "many"), "output.frames: expected a number, found the string \"many\"");
  EXPECT_TRUE(test::contains(refusal("warp.method", "mesh"), "needs a mesh"));
}

}  // namespace
}  // namespace morphkit::project
