#include "cli/edit/view/view.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace morphkit::edit {
namespace {

const cv::Size kPane(640, 480);

void expect_near(cv::Point2d a, cv::Point2d b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Fitted, ShowsAllOfThePictureInTheMiddleAndTouchesTheMargin) {
  for (const cv::Size picture : {cv::Size(4000, 100), cv::Size(100, 4000), cv::Size(640, 480), cv::Size(31, 17)}) {
    SCOPED_TRACE(picture.width);
    const View view = fitted(picture, kPane);
    const cv::Point2d first = view.to_pane({0, 0}, kPane);
    const cv::Point2d last = view.to_pane(cv::Point2d(picture.width, picture.height), kPane);
    expect_near(first + last, cv::Point2d(kPane.width, kPane.height), 1e-9);
    const double margin = std::min(first.x, first.y);
    EXPECT_GT(margin, 0);
    EXPECT_LT(margin, 20);
  }
}

TEST(Fitted, KeepsTheZoomWithinItsBounds) {
  EXPECT_EQ(fitted({1, 1}, kPane).zoom, kMaxZoom);
  EXPECT_EQ(fitted({1 << 24, 8}, kPane).zoom, kMinZoom);
  EXPECT_GT(fitted({100, 100}, {3, 3}).zoom, 0);
}

TEST(Zoomed, WhatLiesAtTheMouseStaysThere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-100, 700), power(-3, 3);
  View view = fitted({1920, 1080}, kPane);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const cv::Point2d mouse(anywhere(random), anywhere(random));
    const cv::Point2d before = view.to_picture(mouse, kPane);
    view = zoomed(view, std::exp(power(random)), mouse, kPane);
    ASSERT_GE(view.zoom, kMinZoom);
    ASSERT_LE(view.zoom, kMaxZoom);
    const double picture_px = std::max(1.0, std::abs(before.x) + std::abs(before.y)) * 1e-12;
    expect_near(view.to_picture(mouse, kPane), before, picture_px);
  }
}

TEST(Zoomed, StaysPutAtTheBounds) {
  const View nearest{kMaxZoom, {5, 6}}, farthest{kMinZoom, {5, 6}};
  EXPECT_EQ(zoomed(nearest, 2, {3, 4}, kPane), nearest);
  EXPECT_EQ(zoomed(farthest, 0.5, {3, 4}, kPane), farthest);
}

TEST(View, ToPaneAndToPictureAreInverse) {
  const View view{3.25, {17, -4}};
  expect_near(view.to_picture(view.to_pane({123.5, 77}, kPane), kPane), {123.5, 77}, 1e-9);
  expect_near(view.to_pane({17, -4}, kPane), {320, 240}, 1e-9);
}

TEST(Matching, ShowsTheSamePartOfAnotherPicture) {
  const View view{0.5, {300, 100}};
  const View other = matching(view, {600, 400}, {1200, 1000});
  EXPECT_EQ(other.zoom, 0.25);
  expect_near(other.centre, {600, 250}, 1e-9);
  const View back = matching(other, {1200, 1000}, {600, 400});
  EXPECT_EQ(back.zoom, view.zoom);
  expect_near(back.centre, view.centre, 1e-9);
}

TEST(Matching, TheFitOfOnePictureIsTheFitOfAnotherOfThatShape) {
  const View first = fitted({600, 400}, kPane), second = fitted({1800, 1200}, kPane);
  const View matched = matching(first, {600, 400}, {1800, 1200});
  EXPECT_NEAR(matched.zoom, second.zoom, 1e-12);
  expect_near(matched.centre, second.centre, 1e-9);
}

}  // namespace
}  // namespace morphkit::edit
