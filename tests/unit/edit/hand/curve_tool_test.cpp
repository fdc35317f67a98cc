// Tests cli/edit/hand/toolbox.cpp.

#include "cli/edit/hand/curve_tool.h"

#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/marks.h"
#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

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

}  // namespace
}  // namespace morphkit::edit
