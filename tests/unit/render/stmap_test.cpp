#include "morph/render/stmap.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace morphkit::render {
namespace {

warp::Map identity(cv::Size size) {
  warp::Map map(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) map(y, x) = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
  return map;
}

TEST(STMap, PixelCentresAreHalfAPixelIn) {
  const warp::Map map = stmap(identity({8, 4}), {8, 4});
  EXPECT_EQ(map(3, 0), warp::MapPoint(0.5f / 8, 0.5f / 4));
  EXPECT_EQ(map(0, 7), warp::MapPoint(7.5f / 8, 3.5f / 4));
}

TEST(STMap, TopLeftOriginRunsDown) {
  const warp::Map map = stmap(identity({8, 4}), {8, 4}, Origin::kTopLeft);
  EXPECT_EQ(map(0, 0), warp::MapPoint(0.5f / 8, 0.5f / 4));
  EXPECT_EQ(map(3, 7), warp::MapPoint(7.5f / 8, 3.5f / 4));
}

TEST(STMap, IsRelativeToTheSourceNotToTheMap) {
  EXPECT_EQ(stmap(identity({8, 4}), {16, 2}, Origin::kTopLeft)(1, 7), warp::MapPoint(7.5f / 16, 1.5f / 2));
}

TEST(STMap, NothingStaysNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const warp::Map map = stmap(warp::Map(1, 1, warp::MapPoint(nan, nan)), {4, 4});
  EXPECT_TRUE(std::isnan(map(0, 0)[0]));
  EXPECT_TRUE(std::isnan(map(0, 0)[1]));
}

}  // namespace
}  // namespace morphkit::render
