// Tests cli/edit/hand/box_drag.cpp, cli/edit/hand/line_tool.cpp, cli/edit/hand/point_tool.cpp,
// cli/edit/hand/select_tool.cpp, cli/edit/hand/tool.cpp and cli/edit/hand/tool_context.cpp.
// Whole sessions of the mouse: marking, dragging, selecting, snapping, looking around.

#include "cli/edit/hand/gestures.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/marks.h"
#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

TEST_F(GestureSession, MarksDragsUndoesSwapsAndGroups) {
  mark_three_lines();
  ASSERT_EQ(features().size(), 3U);
  EXPECT_EQ(features()[1].places[project::kSource], (std::vector<cv::Point2d>{{100, 150}, {300, 150}}));
  EXPECT_EQ(selected(), Indices{2});

  drag(project::kDestination, {300, 150}, {320, 130});
  EXPECT_EQ(features()[1].places[project::kDestination][1], cv::Point2d(320, 130));
  EXPECT_EQ(features()[1].places[project::kSource][1], cv::Point2d(300, 150));
  EXPECT_EQ(selected(), Indices{1});
  key('z');
  EXPECT_EQ(features()[1].places[project::kDestination][1], cv::Point2d(300, 150))
      << "from press to release is one step";
  key('y');
  EXPECT_EQ(features()[1].places[project::kDestination][1], cv::Point2d(320, 130));

  move(project::kDestination, {10, 10});
  key('w');
  EXPECT_EQ(features()[1].places[project::kDestination][0], cv::Point2d(320, 130));
  EXPECT_EQ(features()[1].places[project::kSource][0], cv::Point2d(100, 150));
  key('e');
  EXPECT_EQ(features()[1].places[project::kDestination][1], cv::Point2d(320, 130));
  EXPECT_EQ(features()[1].places[project::kSource][0], cv::Point2d(300, 150));

  key('a');
  key('g');
  type("eye");
  key(kKeyEnter);
  for (const project::Feature& feature : features()) EXPECT_EQ(feature.group, "eye");
  EXPECT_EQ(steps_back(), 3 + 1 + 2 + 1);
}

TEST_F(GestureSession, TheFarEndOfANewPartnerIsHeld) {
  drag(project::kSource, {100, 50}, {300, 50});
  EXPECT_EQ(model.held, (Handle{project::kDestination, 0, 1, -1}));
  move(project::kDestination, {10, 10});
  type("lki");
  EXPECT_EQ(features()[0].places[project::kDestination], (std::vector<cv::Point2d>{{100, 50}, {301, 50}}));
  move(project::kSource, {10, 10});
  key('j');
  EXPECT_EQ(features()[0].places[project::kSource], (std::vector<cv::Point2d>{{99, 50}, {299, 50}}))
      << "nothing is held there";
}

TEST_F(GestureSession, NudgesByAPixelOfTheScreen) {
  drag(project::kSource, {100, 50}, {300, 50});
  model.source_view.zoom = 4;
  move(project::kSource, {200, 150});
  key('k');
  EXPECT_EQ(features()[0].places[project::kSource][0], cv::Point2d(100, 50.25));
}

TEST_F(GestureSession, KeysActWhereTheHandIsOrWasLast) {
  drag(project::kDestination, {100, 50}, {300, 50});
  const auto nudged = [&] { return features()[0].places[project::kDestination][0] != cv::Point2d(100, 50); };
  key('a');
  const cv::Rect result = layout().pane(Pane::kResult);
  drag(result.tl() + cv::Point(9, 9), result.tl() + cv::Point(30, 30));
  mouse(What::kMove, {800, 895});  // the status line
  key('l');
  EXPECT_TRUE(nudged()) << "the side of the last press";
  key('z');
  click(project::kSource, {20, 20});
  key('a');
  move(project::kDestination, {20, 20});
  key('l');
  EXPECT_TRUE(nudged()) << "the side under the mouse";
  key('z');
  click(project::kDestination, {100, 50});
  mouse(What::kMove, {800, 895});
  key('w');
  EXPECT_EQ(features()[0].places[project::kDestination][0], cv::Point2d(300, 50));
  EXPECT_EQ(features()[0].places[project::kSource][0], cv::Point2d(100, 50));
}

TEST_F(GestureSession, NudgesAreShortInTheFile) {
  drag(project::kSource, {100, 50}, {300, 50});
  model.source_view.zoom = 0.37;
  key('a');
  move(project::kSource, {200, 150});
  key('l');
  EXPECT_EQ(features()[0].places[project::kSource][0], cv::Point2d(102.7, 50));
}

TEST_F(GestureSession, AllAndTheNextAreOfWhatTheToolHolds) {
  mark_three_lines();
  key('5');
  click(project::kSource, {30, 80});
  key('a');
  EXPECT_EQ(document().selection().vertices.size(), 25U);
  EXPECT_TRUE(selected().empty());
  key(kKeyTab);
  EXPECT_EQ(document().selection().vertices, Indices{0});
  key(kKeyTab);
  EXPECT_EQ(document().selection().vertices, Indices{1});
  key('2');
  key('a');
  EXPECT_EQ(selected(), (Indices{0, 1, 2})) << "whatever warps";
  key(kKeyTab);
  EXPECT_EQ(selected(), Indices{0});
}

TEST_F(GestureSession, AClickWithTheLineToolMakesNothingButDeselects) {
  drag(project::kSource, {100, 50}, {300, 50});
  drag(project::kSource, {200, 150}, {202, 152});
  EXPECT_EQ(features().size(), 1U);
  EXPECT_TRUE(selected().empty());
}

TEST_F(GestureSession, EndsComeBeforeBodiesAndTheNearestWinsInEveryTool) {
  mark_three_lines();
  for (const char tool : {'1', '2', '3', '4'}) {
    SCOPED_TRACE(tool);
    key(tool);
    move(project::kSource, {294, 155});
    EXPECT_EQ(model.hover, (Handle{project::kSource, 1, 1, -1}));
    move(project::kSource, {200, 154});
    EXPECT_EQ(model.hover, (Handle{project::kSource, 1, -1, -1}));
    move(project::kSource, {200, 158});
    EXPECT_FALSE(model.hover);
    press(project::kSource, {300, 150});
    EXPECT_EQ(model.held, (Handle{project::kSource, 1, 1, -1}));
    release();
    EXPECT_EQ(features().size(), 3U);
  }
}

TEST_F(GestureSession, CtrlDrawsWhereAMarkCouldBeDragged) {
  mark_three_lines();
  keys.ctrl = true;
  drag(project::kSource, {297, 152}, {350, 220});
  ASSERT_EQ(features().size(), 4U);
  EXPECT_EQ(features()[3].places[project::kSource], (std::vector<cv::Point2d>{{300, 150}, {350, 220}}))
      << "from the end under it";
  EXPECT_EQ(features()[1].places[project::kSource][1], cv::Point2d(300, 150));
  key('3');
  click(project::kSource, {200, 250});
  EXPECT_EQ(features().size(), 5U);
  key('1');
  click(project::kSource, {200, 250});
  EXPECT_EQ(features().size(), 5U) << "elsewhere it selects";
}

TEST_F(GestureSession, HiddenMarksAreNotHeldAndDrawingShowsThem) {
  mark_three_lines();
  key('m');
  move(project::kSource, {300, 150});
  EXPECT_FALSE(model.hover);
  drag(project::kSource, {305, 150}, {350, 220});
  EXPECT_EQ(features().size(), 4U);
  EXPECT_EQ(features()[1].places[project::kSource][1], cv::Point2d(300, 150));
  EXPECT_TRUE(model.switches.features);
}

TEST_F(GestureSession, AMarkThatDoesNothingSaysSo) {
  drag(project::kSource, {100, 50}, {300, 50});
  EXPECT_NE(model.message.find("put its partner right"), std::string::npos) << model.message;
  key('5');
  click(project::kSource, {30, 80});
  ASSERT_EQ(document().method(), project::MethodName::kMesh);
  for (const char tool : {'2', '3', '4'}) {
    key(tool);
    drag(project::kSource, {110.0 + tool, 180}, {300, 230});
    click(project::kSource, {120.0 + tool, 280});
    key(kKeyEnter);
    EXPECT_NE(model.message.find("does nothing while the mesh warps"), std::string::npos) << model.message;
  }
  click(Command::kNextMethod);
  key('5');
  press(project::kSource, {200, 150});
  EXPECT_NE(model.message.find("the lines warp"), std::string::npos) << model.message;
}

TEST_F(GestureSession, SlidersAreTakenByTheirTracksOnly) {
  const cv::Rect slider = widget(Tuning::kA).rect;
  for (const int x : {slider.x + 3, slider.br().x - 3}) {  // its letter, its value
    drag({x, slider.y + slider.height / 2}, {slider.x + slider.width / 2, slider.y + slider.height / 2});
    EXPECT_EQ(steps_back(), 0);
  }
  drag(on_slider(Tuning::kA, 0), on_slider(Tuning::kA, 0.5));
  EXPECT_NEAR(document().tuning(Tuning::kA), 25, 1);
}

TEST_F(GestureSession, RubberBandsSelectAndAdd) {
  mark_three_lines();
  key('1');
  drag(project::kSource, {90, 260}, {110, 140});
  EXPECT_EQ(selected(), (Indices{1, 2}));
  keys.shift = true;
  drag(project::kDestination, {90, 40}, {320, 60});
  EXPECT_EQ(selected(), (Indices{0, 1, 2}));
  keys.shift = false;
  click(project::kSource, {20, 20});
  EXPECT_TRUE(selected().empty());
  EXPECT_FALSE(model.sketch);
  key('2');
  keys.shift = true;
  drag(project::kSource, {90, 260}, {110, 240});
  EXPECT_EQ(selected(), Indices{2}) << "with Shift in any tool";
  EXPECT_EQ(features().size(), 3U);
}

TEST_F(GestureSession, APointIsPlacedAndAdjustedInOneStep) {
  key('3');
  drag(project::kDestination, {100, 100}, {120, 110});
  ASSERT_EQ(features().size(), 1U);
  EXPECT_EQ(features()[0].places[project::kDestination], (std::vector<cv::Point2d>{{120, 110}}));
  EXPECT_EQ(features()[0].places[project::kSource], (std::vector<cv::Point2d>{{100, 100}}));
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(GestureSession, SnapsToEndsThenToEdgesUnlessTold) {
  drag(project::kSource, {100, 50}, {300, 50});
  edges = [](SideIndex, cv::Point2d position) { return cv::Point2d(position.x, 200); };
  press(project::kSource, {100, 196});
  EXPECT_EQ(model.snapped, cv::Point2d(100, 200));
  EXPECT_EQ(asked.radius, kEdgeReach);
  EXPECT_EQ(asked.zoom, 1);
  move(project::kSource, {296, 55});
  EXPECT_EQ(model.snapped, cv::Point2d(300, 50)) << "ends first";
  release();
  EXPECT_FALSE(model.snapped);
  EXPECT_EQ(features()[1].places[project::kSource], (std::vector<cv::Point2d>{{100, 200}, {300, 50}}));

  keys.alt = true;
  drag(project::kSource, {150, 120}, {250, 120});
  EXPECT_EQ(features()[2].places[project::kSource][0], cv::Point2d(150, 120));
  keys.alt = false;
  key('b');
  drag(project::kSource, {150, 140}, {250, 140});
  EXPECT_EQ(features()[3].places[project::kSource][0], cv::Point2d(150, 140));
  key('b');
  edges = nullptr;
  drag(project::kSource, {150, 140}, {251, 125});
  EXPECT_EQ(features()[3].places[project::kSource][0], cv::Point2d(250, 120)) << "while an end is dragged, too";
}

TEST_F(GestureSession, ReachesAreThoseOfTheScreen) {
  model.source_view.zoom = 4;
  edges = [](SideIndex, cv::Point2d) { return std::nullopt; };
  press(project::kSource, {200, 150});
  EXPECT_EQ(asked.radius, kEdgeReach / 4);
  EXPECT_EQ(asked.zoom, 4);
  release();
}

TEST_F(GestureSession, EscInTheMiddleOfAnythingRestores) {
  mark_three_lines();
  key('3');
  click(project::kSource, {350, 100});
  key('5');
  click(project::kSource, {30, 30});
  struct Case {
    char tool;
    cv::Point from, to;
  };
  const Case cases[] = {
      {'1', at(project::kSource, {300, 150}), at(project::kSource, {250, 200})},       // an end
      {'1', at(project::kSource, {200, 150}), at(project::kDestination, {250, 200})},  // a line
      {'1', at(project::kSource, {20, 20}), at(project::kSource, {350, 280})},         // a rubber band
      {'2', at(project::kSource, {20, 20}), at(project::kSource, {350, 280})},         // a new line
      {'3', at(project::kSource, {20, 20}), at(project::kSource, {350, 280})},         // a new point
      {'4', at(project::kSource, {20, 20}), at(project::kSource, {350, 280})},         // a new curve
      {'5', at(project::kSource, {200, 150}), at(project::kSource, {230, 180})},       // a vertex
      {'1', on_slider(Tuning::kA, 0.2), on_slider(Tuning::kA, 0.9)},
  };
  const project::Project before = document().project();
  for (const Case& test : cases) {
    SCOPED_TRACE(testing::Message() << "tool " << test.tool << " from " << test.from);
    key(test.tool);
    mouse(What::kPress, test.from);
    mouse(What::kMove, (test.from + test.to) / 2);
    mouse(What::kMove, test.to);
    key(kKeyEscape);
    EXPECT_TRUE(project::same_document(document().project(), before));
    mouse(What::kMove, test.from);
    release();
    EXPECT_TRUE(project::same_document(document().project(), before));
    EXPECT_FALSE(document().in_step());
    EXPECT_FALSE(model.sketch);
    EXPECT_FALSE(model.held);
    EXPECT_FALSE(model.snapped);
  }
  EXPECT_EQ(steps_back(), 5);
}

}  // namespace
}  // namespace morphkit::edit
