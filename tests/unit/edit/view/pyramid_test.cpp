#include "cli/edit/view/pyramid.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "cli/edit/view/screen.h"
#include "tests/support/pictures.h"
#include "warp/image/color.h"

namespace morphkit::edit {
namespace {

TEST(Pyramid, LevelZeroIsThePictureItself) {
  const warp::Image picture = test::random_image({40, 30}, 1);
  const Pyramid pyramid(picture);
  EXPECT_EQ(pyramid.size(), picture.size());
  EXPECT_EQ(pyramid.light(1).data, picture.data);
  EXPECT_EQ(pyramid.light(0.001).data, picture.data);  // small already
}

TEST(Pyramid, NoLevelNeedsMagnifyingUnlessAllDo) {
  for (const cv::Size size : {cv::Size(1031, 700), cv::Size(1024, 3), cv::Size(1, 2000)}) {
    const Pyramid pyramid(test::random_image(size, 2));
    cv::Size before = size;
    for (double scale = 2; scale > 1e-3; scale *= 0.93) {
      SCOPED_TRACE(testing::Message() << size << " at " << scale);
      const cv::Size level = pyramid.light(scale).size();
      EXPECT_GE(level.width, size.width * std::min(1.0, scale));
      EXPECT_GE(level.height, size.height * std::min(1.0, scale));
      EXPECT_LE(level.width, before.width);
      EXPECT_EQ(pyramid.display(scale).size(), level);
      before = level;
    }
    EXPECT_LE(std::max(before.width, before.height), kSmallestLevel);
  }
}

TEST(Pyramid, LevelsHalve) {
  const Pyramid pyramid(test::random_image({1031, 700}, 3));
  EXPECT_EQ(pyramid.level(1), 0U);
  EXPECT_EQ(pyramid.level(0.51), 0U);
  EXPECT_EQ(pyramid.level(0.5), 1U);
  EXPECT_EQ(pyramid.light(0.5).size(), cv::Size(516, 350));
  EXPECT_EQ(pyramid.light(0.25).size(), cv::Size(258, 175));
}

TEST(Pyramid, LevelsKeepTheLight) {
  const Pyramid pyramid(test::random_image({1024, 512}, 4, true));
  const cv::Scalar whole = cv::mean(pyramid.light(1)), last = cv::mean(pyramid.light(0.1));
  ASSERT_LT(pyramid.light(0.1).cols, 300);
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(whole[c], last[c], 1e-5) << c;
}

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
