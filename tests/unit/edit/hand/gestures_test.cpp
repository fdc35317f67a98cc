// Whole sessions of the mouse: marking, dragging, selecting, snapping, looking around.

#include "cli/edit/hand/gestures.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/marks.h"
#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

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

TEST_F(GestureSession, AClickMovesNothingEvenIfTheHandTrembles) {
  mark_three_lines();
  edges = [](SideIndex, cv::Point2d position) { return position + cv::Point2d(5, 5); };
  for (const cv::Point2d start : {cv::Point2d(297, 152), cv::Point2d(200, 152)}) {  // an end, and a whole
    press(project::kSource, start);
    move(project::kSource, start + cv::Point2d(2, -2));
    move(project::kSource, start + cv::Point2d(3, 1));
    release();
    EXPECT_EQ(features()[1].places[project::kSource], (std::vector<cv::Point2d>{{100, 150}, {300, 150}}));
    EXPECT_EQ(selected(), Indices{1});
  }
  EXPECT_EQ(steps_back(), 3);
}

TEST_F(GestureSession, ADragThatComesBackChangesNothing) {
  mark_three_lines();
  key('a');
  model.document.move_selected(project::kSource, {1.0 / 3, 0});
  const std::vector<cv::Point2d> before = features()[1].places[project::kSource];
  for (const cv::Point2d start : {cv::Point2d(297, 152), cv::Point2d(200, 152)}) {
    press(project::kSource, start);
    move(project::kSource, start + cv::Point2d(20, 0));
    EXPECT_NE(features()[1].places[project::kSource], before);
    move(project::kSource, start + cv::Point2d(1, 0));
    EXPECT_NE(features()[1].places[project::kSource], before) << "a drag goes on as finely as the hand";
    move(project::kSource, start);
    EXPECT_EQ(features()[1].places[project::kSource], before);
    release();
  }
  EXPECT_EQ(steps_back(), 3 + 1);
}

TEST_F(GestureSession, AClickOnOneOfSeveralSelectsItAlone) {
  mark_three_lines();
  key('a');
  click(project::kSource, {200, 150});
  EXPECT_EQ(selected(), Indices{1});
  EXPECT_EQ(model.held, (Handle{project::kSource, 1, -1, -1}));
  key('a');
  drag(project::kSource, {200, 150}, {200, 160});
  EXPECT_EQ(selected(), (Indices{0, 1, 2})) << "a drag moves them all";
  key('5');
  click(project::kSource, {30, 30});
  key('a');
  click(project::kSource, {200, 150});
  EXPECT_EQ(document().selection().vertices, Indices{12});
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

TEST_F(GestureSession, TheBodyDragsTheFeatureAndAllThatAreSelectedWithIt) {
  mark_three_lines();
  key('1');
  drag(project::kSource, {200, 150}, {210, 160});
  EXPECT_EQ(features()[1].places[project::kSource], (std::vector<cv::Point2d>{{110, 160}, {310, 160}}));
  EXPECT_EQ(features()[1].places[project::kDestination][0], cv::Point2d(100, 150)) << "on that side alone";
  keys.shift = true;
  click(project::kSource, {200, 50});
  EXPECT_EQ(selected(), (Indices{0, 1}));
  keys.shift = false;
  drag(project::kSource, {200, 50}, {195, 40});
  EXPECT_EQ(features()[0].places[project::kSource][0], cv::Point2d(95, 40));
  EXPECT_EQ(features()[1].places[project::kSource][0], cv::Point2d(105, 150));
  EXPECT_EQ(features()[2].places[project::kSource][0], cv::Point2d(100, 250));
  keys.shift = true;
  click(project::kSource, {195, 40});
  EXPECT_EQ(selected(), Indices{1});
  EXPECT_EQ(steps_back(), 3 + 2);
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

TEST_F(GestureSession, CurvesEndOpenOrClosed) {
  const std::vector<cv::Point2d> places = {{100, 100}, {200, 60}, {300, 100}};
  const auto click_all = [&] {
    for (const cv::Point2d place : places) click(project::kSource, place);
  };
  key('4');
  click_all();
  EXPECT_EQ(model.sketch->points, places);
  EXPECT_TRUE(features().empty());
  key(kKeyEnter);
  ASSERT_EQ(features().size(), 1U);
  EXPECT_EQ(features()[0].places[project::kSource], places);
  EXPECT_FALSE(is_closed(features()[0].mark));
  key('x');

  click_all();
  mouse(What::kDoubleClick, at(project::kSource, places.back()));
  ASSERT_EQ(features().size(), 1U);
  EXPECT_EQ(features()[0].places[project::kSource], places);
  EXPECT_FALSE(is_closed(features()[0].mark));
  key('x');

  click_all();
  click(project::kSource, places.front());
  ASSERT_EQ(features().size(), 1U);
  EXPECT_TRUE(is_closed(features()[0].mark));
  EXPECT_FALSE(model.sketch);
}

TEST_F(GestureSession, ACurveIsTakenBackPointByPointOrWhole) {
  key('4');
  click(project::kSource, {100, 100});
  click(project::kSource, {200, 60});
  key(kKeyBackspace);
  EXPECT_EQ(model.sketch->points.size(), 1U);
  key(kKeyEnter);
  EXPECT_FALSE(model.sketch) << "one point is no curve";
  click(project::kSource, {100, 100});
  key(kKeyBackspace);
  EXPECT_FALSE(model.sketch);
  click(project::kSource, {100, 100});
  click(project::kSource, {200, 60});
  key(kKeyEscape);
  EXPECT_FALSE(model.sketch);
  click(project::kSource, {100, 100});
  click(project::kSource, {200, 60});
  key('y');
  EXPECT_EQ(model.sketch->points.size(), 2U) << "there is nothing to redo";
  click(Command::kUndo);
  EXPECT_EQ(model.sketch->points.size(), 1U);
  key('z');
  EXPECT_FALSE(model.sketch);
  EXPECT_TRUE(features().empty());
  EXPECT_EQ(steps_back(), 0);
}

TEST_F(GestureSession, AnotherToolEndsTheCurve) {
  for (const bool by_key : {false, true}) {
    key('4');
    click(project::kSource, {100, 100});
    click(project::kSource, {200, 60});
    key('4');
    EXPECT_TRUE(model.sketch) << "the same tool goes on";
    if (by_key) {
      key('2');
    } else {
      click(ToolId::kLine);
    }
    EXPECT_FALSE(model.sketch);
    ASSERT_EQ(features().size(), 1U);
    EXPECT_EQ(features()[0].places[project::kSource], (std::vector<cv::Point2d>{{100, 100}, {200, 60}}));
    key('x');
  }
}

TEST_F(GestureSession, MeshesAreMadeDraggedGrownAndShrunk) {
  key('5');
  click(project::kSource, {30, 30});
  ASSERT_TRUE(document().has_mesh());
  EXPECT_EQ(document().method(), project::MethodName::kMesh);
  const auto vertex = [&](SideIndex side, int i) {
    return document().mesh_vertices(side)[static_cast<std::size_t>(i)];
  };
  drag(project::kDestination, {200, 150}, {210, 140});
  EXPECT_EQ(vertex(project::kDestination, 12), cv::Point2d(210, 140));
  EXPECT_EQ(vertex(project::kSource, 12), cv::Point2d(200, 150));
  EXPECT_EQ(document().selection().vertices, Indices{12});
  type("c");  // the mouse is on the vertex, where there is no room: a little beside it
  EXPECT_EQ(document().project().mesh->columns, 6);
  move(project::kSource, {50, 37});
  type("r");
  EXPECT_EQ(document().project().mesh->rows, 6);
  EXPECT_NEAR(vertex(project::kSource, 6).y, 37, 1e-9);
  click(project::kSource, {100, 150});
  type(",.");
  EXPECT_EQ(document().project().mesh->columns, 5);
  EXPECT_EQ(document().project().mesh->rows, 6) << "the vertex has gone with its column";
  click(project::kSource, {0, 0});
  type(".");
  EXPECT_EQ(document().project().mesh->rows, 6) << "the border stays";
  EXPECT_EQ(steps_back(), 5);
}

TEST_F(GestureSession, VerticesThatABorderHeldBackComeBackUnderTheHand) {
  key('5');
  click(project::kSource, {30, 30});
  keys.shift = true;
  drag(project::kSource, {90, 140}, {210, 160});
  keys.shift = false;
  EXPECT_EQ(document().selection().vertices, (Indices{11, 12}));
  press(project::kSource, {100, 150});
  move(project::kSource, {-50, 150});
  EXPECT_EQ(document().mesh_vertices(project::kSource)[11], cv::Point2d(0, 150));
  move(project::kSource, {90, 150});
  EXPECT_EQ(document().mesh_vertices(project::kSource)[11], cv::Point2d(90, 150));
  EXPECT_EQ(document().mesh_vertices(project::kSource)[12], cv::Point2d(190, 150));
  release();
  EXPECT_EQ(steps_back(), 2);
}

TEST_F(GestureSession, MeshKeysWaitForTheMeshTool) {
  key('5');
  click(project::kSource, {30, 30});
  key('2');
  move(project::kSource, {50, 37});
  type("cr");
  EXPECT_EQ(document().project().mesh->columns, 5);
  EXPECT_EQ(document().project().mesh->rows, 5);
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

TEST(GestureViews, TheWheelKeepsWhatIsUnderTheMouseStillAndTheOtherPictureFollows) {
  Hand hand({800, 450});
  hand.model.fit_views();
  for (const Pane pane : kPanes)
    for (const double notches : {1.0, 3.0, -2.0, 0.5}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(pane) << " by " << notches);
      const cv::Rect rect = hand.layout().pane(pane);
      const cv::Point mouse = rect.tl() + cv::Point(rect.width / 3, rect.height / 4);
      const cv::Point2d before = hand.under(pane, mouse);
      const double zoom = hand.model.view(pane).zoom;
      const View result = hand.model.result_view;
      hand.wheel(mouse, notches);
      const cv::Point2d after = hand.under(pane, mouse);
      EXPECT_NEAR(after.x, before.x, 1e-9);
      EXPECT_NEAR(after.y, before.y, 1e-9);
      EXPECT_NEAR(hand.model.view(pane).zoom, zoom * std::pow(1.2, notches), 1e-9);
      if (pane == Pane::kResult) continue;
      EXPECT_EQ(hand.model.result_view, result);
      const View& source = hand.model.source_view;
      const View& destination = hand.model.destination_view;
      EXPECT_NEAR(destination.zoom, source.zoom / 2, 1e-12);
      EXPECT_NEAR(destination.centre.x / 800, source.centre.x / 400, 1e-12);
      EXPECT_NEAR(destination.centre.y / 450, source.centre.y / 300, 1e-12);
    }
}

TEST_F(GestureSession, FreePicturesZoomAloneAndMeetAgainWhenLocked) {
  key('t');
  wheel(at(project::kSource, {50, 50}), 3);
  EXPECT_EQ(model.destination_view, (View{1, {200, 150}}));
  key('t');
  EXPECT_EQ(model.destination_view, model.source_view);
}

TEST_F(GestureSession, RightAndMiddlePanAndTheResultByTheLeft) {
  for (const Button button : {Button::kRight, Button::kMiddle}) {
    model.source_view = model.destination_view = {1, {200, 150}};
    drag(at(project::kSource, {100, 100}), at(project::kSource, {130, 90}), button);
    EXPECT_EQ(model.source_view.centre, cv::Point2d(170, 160));
    EXPECT_EQ(model.destination_view.centre, cv::Point2d(170, 160));
  }
  const cv::Rect rect = layout().pane(Pane::kResult);
  const cv::Point middle = (rect.tl() + rect.br()) / 2;
  const cv::Point2d before = under(Pane::kResult, middle);
  drag(middle, middle + cv::Point(40, 30));
  const cv::Point2d after = under(Pane::kResult, middle + cv::Point(40, 30));
  EXPECT_NEAR(after.x, before.x, 1e-9);
  EXPECT_NEAR(after.y, before.y, 1e-9);
  EXPECT_EQ(model.source_view.centre, cv::Point2d(170, 160));
  EXPECT_EQ(steps_back(), 0);
}

TEST_F(GestureSession, ADoubleClickOnBlankFits) {
  const View fit = fitted(kPicture, layout().pane(Pane::kSource).size());
  wheel(at(project::kSource, {50, 50}), 3);
  click(project::kSource, {100, 100});
  mouse(What::kDoubleClick, at(project::kSource, {100, 100}));
  release();
  EXPECT_EQ(model.source_view, fit);
  EXPECT_EQ(model.destination_view, fit);
  EXPECT_TRUE(features().empty());
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
