#include "cli/edit/view/screen.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"
#include "warp/image/color.h"

namespace morphkit::edit {
namespace {

TEST(Screen, IsTheCodesInBgr) {
  const warp::Image picture = test::random_image({67, 9}, 5);
  const cv::Mat3b screen = to_screen(picture);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      for (int c = 0; c < 3; ++c) {
        const double code = 255.0 * warp::srgb_from_linear(std::clamp(picture(y, x)[c], 0.0F, 1.0F));
        ASSERT_NEAR(screen(y, x)[2 - c], code, 0.51) << x << " " << y << " " << c;
      }
}

TEST(Screen, WhatIsTransparentShowsTwoGreysThatAreNeitherBlackNorWhite) {
  const cv::Mat3b screen = to_screen(warp::Image(16, 16, warp::Pixel(0, 0, 0, 0)));
  EXPECT_NE(screen(0, 0), screen(0, 8));
  EXPECT_NE(screen(0, 0), screen(8, 0));
  EXPECT_EQ(screen(0, 0), screen(8, 8));
  for (const cv::Vec3b& pixel : screen) {
    EXPECT_EQ(pixel[0], pixel[1]);
    EXPECT_EQ(pixel[1], pixel[2]);
    EXPECT_GT(pixel[0], 40);
    EXPECT_LT(pixel[0], 215);
  }
}

TEST(Screen, HalfTransparentWhiteLiesBetweenTheChecksAndWhite) {
  const cv::Mat3b screen = to_screen(warp::Image(4, 4, warp::Pixel(0.5F, 0.5F, 0.5F, 0.5F)));
  const cv::Mat3b checks = to_screen(warp::Image(4, 4, warp::Pixel(0, 0, 0, 0)));
  EXPECT_GT(screen(0, 0)[0], checks(0, 0)[0]);
  EXPECT_LT(screen(0, 0)[0], 255);
}

}  // namespace
}  // namespace morphkit::edit
