#include "cli/edit/view/paint.h"

#include <gtest/gtest.h>

namespace morphkit::edit {
namespace {

const cv::Vec3b kBlack(0, 0, 0), kRed(0, 0, 200);

TEST(Paint, MixedColoursEndAtBoth) {
  EXPECT_EQ(mixed(kBlack, kRed, 0), kBlack);
  EXPECT_EQ(mixed(kBlack, kRed, 1), kRed);
  EXPECT_EQ(mixed(kBlack, kRed, 0.5), cv::Vec3b(0, 0, 100));
}

TEST(Paint, ARectangleIsFilledAndCutAtThePicture) {
  cv::Mat3b picture(20, 30, kBlack);
  fill(picture, {10, 5, 100, 10}, kRed);
  EXPECT_EQ(picture(5, 10), kRed);
  EXPECT_EQ(picture(14, 29), kRed);
  EXPECT_EQ(picture(4, 10), kBlack);
  EXPECT_EQ(picture(15, 10), kBlack);
  EXPECT_EQ(picture(5, 9), kBlack);
}

TEST(Paint, RoundCornersAreLeftOutAndHalfACoverMixes) {
  cv::Mat3b picture(40, 40, kBlack);
  fill(picture, {0, 0, 40, 40}, kRed, 12);
  EXPECT_EQ(picture(0, 0), kBlack);
  EXPECT_EQ(picture(6, 6), kRed) << "within the radius";
  EXPECT_EQ(picture(0, 20), kRed);
  EXPECT_EQ(picture(20, 20), kRed);
  cv::Mat3b half(9, 9, kBlack);
  fill(half, {0, 0, 9, 9}, kRed, 0, 0.5);
  EXPECT_NEAR(half(4, 4)[2], 100, 1);
}

TEST(Paint, DiscsAreRoundAboutTheirCentre) {
  cv::Mat3b picture(41, 41, kBlack);
  disc(picture, {20.5, 20.5}, 10, kRed);
  EXPECT_EQ(picture(20, 20), kRed);
  EXPECT_EQ(picture(20, 20 + 8), kRed);
  EXPECT_EQ(picture(20, 20 + 13), kBlack);
  EXPECT_EQ(picture(20 + 8, 20 + 8), kBlack) << "in the corner of its box";
  EXPECT_EQ(picture(20, 20 - 8), kRed);
}

TEST(Paint, NeighbouringFeaturesHaveDifferentColours) {
  for (int i = 0; i < 30; ++i) EXPECT_NE(feature_color(i), feature_color(i + 1)) << i;
}

}  // namespace
}  // namespace morphkit::edit
