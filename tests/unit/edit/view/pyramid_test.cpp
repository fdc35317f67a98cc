#include "cli/edit/view/pyramid.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

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

}  // namespace
}  // namespace morphkit::edit
