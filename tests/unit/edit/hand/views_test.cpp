#include "cli/edit/hand/views.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;
using test::Hand;
using test::kPicture;

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

}  // namespace
}  // namespace morphkit::edit
