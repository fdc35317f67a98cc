// Tests cli/edit/hand/drag.cpp.

#include "cli/edit/hand/mark_drag.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

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

}  // namespace
}  // namespace morphkit::edit
