#include "morph/render/placement.h"

#include <gtest/gtest.h>

namespace morphkit::render {
namespace {

using project::Fit;

TEST(Placement, IsTheIdentityForEqualSizes) {
  for (const Fit fit : {Fit::kContain, Fit::kCover, Fit::kStretch, Fit::kNone})
    EXPECT_TRUE(place({451, 300}, {451, 300}, fit).is_identity());
}

TEST(Placement, ContainShowsAllAndCoverFillsAll) {
  const cv::Size canvas(640, 360);
  for (const cv::Size image : {cv::Size(300, 451), cv::Size(1920, 1080), cv::Size(3000, 100), cv::Size(1, 1)}) {
    const Placement contain = place(image, canvas, Fit::kContain);
    const cv::Point2d last = contain.to_canvas({double(image.width), double(image.height)});
    EXPECT_GE(contain.offset.x, -1e-9);
    EXPECT_GE(contain.offset.y, -1e-9);
    EXPECT_LE(last.x, canvas.width + 1e-9);
    EXPECT_LE(last.y, canvas.height + 1e-9);
    EXPECT_TRUE(covers(place(image, canvas, Fit::kCover), image, canvas)) << image;
    EXPECT_TRUE(covers(place(image, canvas, Fit::kStretch), image, canvas)) << image;
  }
  EXPECT_FALSE(covers(place({300, 451}, canvas, Fit::kContain), {300, 451}, canvas));
  EXPECT_FALSE(covers(place({100, 100}, canvas, Fit::kNone), {100, 100}, canvas));
}

TEST(Placement, KeepsCentresTogetherAndRoundTrips) {
  const cv::Size image(451, 300), canvas(512, 512);
  for (const Fit fit : {Fit::kContain, Fit::kCover, Fit::kStretch, Fit::kNone}) {
    const Placement placement = place(image, canvas, fit);
    const cv::Point2d centre = placement.to_canvas({225.5, 150});
    EXPECT_NEAR(centre.x, 256, 1e-9);
    EXPECT_NEAR(centre.y, 256, 1e-9);
    const cv::Point2d back = placement.to_image(placement.to_canvas({17.25, 211.5}));
    EXPECT_NEAR(back.x, 17.25, 1e-9);
    EXPECT_NEAR(back.y, 211.5, 1e-9);
  }
}

TEST(Mean, IsExactWhereItMustBe) {
  const cv::Point2d places[] = {{0.1, 0.7}, {33.3, 12.9}, {-7.1, 1e6}};
  const auto place_of = [&](std::size_t side) { return places[side]; };
  for (std::size_t side = 0; side < 3; ++side) {
    std::vector<double> weights(3, 0);
    weights[side] = 1;
    EXPECT_EQ(mean(weights, place_of), places[side]);
  }
  const std::vector<double> thirds{0.3, 0.3, 0.4};
  EXPECT_EQ(mean(thirds, [&](std::size_t) { return places[1]; }), places[1]);
  EXPECT_NEAR(mean(thirds, place_of).x, 0.03 + 9.99 - 2.84, 1e-12);
  EXPECT_EQ(mean(std::vector<double>{0.75, 0.25}, place_of), lerp(places[0], places[1], 0.25));
}

}  // namespace
}  // namespace morphkit::render
