// The paintbox: coverage is area, softening keeps it.

#include "samples/brush.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "samples/noise.h"

namespace morphkit::samples {
namespace {

double total(const Mask& mask) {
  double sum = 0;
  for (const float coverage : mask.coverage) sum += coverage;
  return sum;
}

double shoelace(const Path& path) {
  double twice = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point a = path[i], b = path[(i + 1) % path.size()];
    twice += static_cast<double>(a.x) * b.y - static_cast<double>(b.x) * a.y;
  }
  return std::abs(twice) / 2;
}

TEST(Mask, CoversTheAreaOfATriangle) {
  const Canvas canvas(128, 96);
  Dice dice(11);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    Path triangle;
    for (int corner = 0; corner < 3; ++corner) triangle.emplace_back(dice.between(2, 126), dice.between(2, 94));
    // 24-bit sums over at most 128 pixels of a row: an error of 1/1000 pixel per row is generous.
    EXPECT_NEAR(total(canvas.mask(triangle)), shoelace(triangle), 0.1);
  }
}

TEST(Mask, IsExactOnPixelEdgesAndHalves) {
  const Canvas canvas(16, 16);
  const Mask mask = canvas.mask({{3, 4}, {7.5F, 4}, {7.5F, 9.25F}, {3, 9.25F}});
  EXPECT_EQ(mask.at(3, 4), 1);
  EXPECT_EQ(mask.at(2, 4), 0);
  EXPECT_EQ(mask.at(3, 3), 0);
  EXPECT_EQ(mask.at(7, 5), 0.5F);
  EXPECT_EQ(mask.at(4, 9), 0.25F);
  EXPECT_EQ(mask.at(7, 9), 0.125F);
  EXPECT_EQ(mask.at(8, 5), 0);
}

TEST(Mask, IsClippedToTheCanvas) {
  const Canvas canvas(20, 10);
  const Mask all = canvas.mask({{-50, -50}, {70, -50}, {70, 60}, {-50, 60}});
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_EQ(all.at(x, y), 1) << x << ' ' << y;
  EXPECT_TRUE(canvas.mask({{30, 2}, {40, 2}, {40, 8}}).coverage.empty());
}

TEST(Mask, SofteningKeepsTheAmountOfPaint) {
  const Canvas canvas(200, 200);
  const Path disc = ellipse({100, 100}, 30, 18, 25);
  for (const float sigma : {1.0F, 3.0F, 8.0F}) {
    const double hard = total(canvas.mask(disc));
    EXPECT_NEAR(total(canvas.mask(disc, sigma)) / hard, 1, 1e-3) << "sigma " << sigma;
  }
}

TEST(Smooth, PassesThroughItsPoints) {
  const Path through{{0, 0}, {10, 5}, {7, 20}, {-4, 12}};
  for (const bool closed : {false, true}) {
    const Path fine = smooth(through, closed);
    for (const Point& p : through) {
      float nearest = std::numeric_limits<float>::infinity();
      for (const Point& q : fine) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
      EXPECT_LT(nearest, 1e-4F);
    }
  }
}

TEST(Canvas, KeepsStraightColourUnderPartCoverage) {
  Canvas canvas(8, 8);
  canvas.fill({{2, 2}, {4.5F, 2}, {4.5F, 6}, {2, 6}}, rgb(0xff8000));
  const cv::Mat4b pixels = canvas.to_8bit();
  EXPECT_EQ(pixels(3, 3)[3], 255);
  EXPECT_EQ(pixels(3, 4)[3], 128);
  EXPECT_EQ(pixels(3, 6)[3], 0);
  for (const int x : {3, 4}) {
    EXPECT_EQ(pixels(3, x)[0], 255);
    EXPECT_NEAR(pixels(3, x)[1], 128, 1);  // the dither adds less than one step
    EXPECT_EQ(pixels(3, x)[2], 0);
  }
}

}  // namespace
}  // namespace morphkit::samples
