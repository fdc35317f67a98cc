#include "cli/edit/hand/snap.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::edit {
namespace {

const cv::Size kSize(200, 160);

Pyramid painted(const std::function<float(cv::Point)>& light, cv::Size size = kSize) {
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float value = light({x, y});
      image(y, x) = {value, value, value, 1.0f};
    }
  return Pyramid(image);
}

/// Dark on the left of x = 90, bright on the right.
Pyramid upright_edge() {
  return painted([](cv::Point at) { return at.x < 90 ? 0.05f : 0.7f; });
}

TEST(StrongestEdge, IsFoundWhereItIsAtEveryZoom) {
  const Pyramid picture = upright_edge();
  for (const double zoom : {0.5, 1.0, 1.7, 4.0, 16.0, 64.0})
    for (const double share : {-0.8, -0.3, 0.0, 0.4, 0.9}) {
      SCOPED_TRACE(testing::Message() << "zoom " << zoom << ", " << share << " of the radius away");
      const double radius = 6 / zoom;
      const auto found = strongest_edge(picture, {90 + share * radius, 70.5}, radius, zoom);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->x, 90, 1e-9);
    }
}

TEST(StrongestEdge, IsFoundOnPicturesWhoseSizesDoNotHalve) {
  // Half of 101 rows is 51: rows shrink by another factor than columns.
  const Pyramid picture = painted([](cv::Point at) { return at.y < 90 ? 0.05f : 0.7f; }, {4000, 101});
  const auto found = strongest_edge(picture, {2000, 90}, 8, 0.25);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->y, 90, 1);
}

TEST(StrongestEdge, LiesWithinTheRadius) {
  const Pyramid picture(test::random_image(kSize, 3));
  const Pyramid edge = upright_edge();
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const cv::Point2d at(80 + i % 21 + 0.37, 40 + i / 21.0);
    const double radius = 0.3 + 0.02 * i;
    for (const Pyramid* pyramid : {&picture, &edge}) {
      const auto found = strongest_edge(*pyramid, at, radius, 6 / radius);
      if (!found) continue;
      ++hits;
      EXPECT_LE(std::hypot(found->x - at.x, found->y - at.y), radius + 1e-9);
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(StrongestEdge, IsRefinedAcrossItself) {
  // The row between is a mixture: more of the bright one puts the edge higher up.
  for (const float mixed : {0.15f, 0.25f, 0.4f}) {
    SCOPED_TRACE(mixed);
    const Pyramid picture = painted([&](cv::Point at) { return at.y < 60 ? 0.02f : at.y == 60 ? mixed : 0.7f; });
    const auto found = strongest_edge(picture, {100, 62}, 6, 1);
    ASSERT_TRUE(found);
    EXPECT_GT(found->y, 60);
    EXPECT_LT(found->y, 61);
  }
}

TEST(StrongestEdge, OfTwoTheNearerUnlessTheOtherIsMuchStronger) {
  const auto two = [](float left, float right) {
    return painted([=](cv::Point at) { return 0.1f + (at.x >= 90 ? left : 0) + (at.x >= 98 ? right : 0); });
  };
  EXPECT_NEAR(strongest_edge(two(0.2f, 0.2f), {92, 50}, 7, 1)->x, 90, 0.5);
  EXPECT_NEAR(strongest_edge(two(0.03f, 0.8f), {92, 50}, 7, 1)->x, 98, 0.5);
}

TEST(StrongestEdge, NothingStandsOutOfFlatnessSlopesOrNoise) {
  const Pyramid flat = painted([](cv::Point) { return 0.4f; });
  const Pyramid slope = painted([](cv::Point at) { return 0.2f + 0.002f * static_cast<float>(at.x); });
  // Equally strong everywhere: stripes of two px.
  const Pyramid stripes = painted([](cv::Point at) { return at.x / 2 % 2 == 0 ? 0.1f : 0.6f; });
  for (const Pyramid* picture : {&flat, &slope, &stripes}) {
    EXPECT_FALSE(strongest_edge(*picture, {100, 80}, 6, 1));
    EXPECT_FALSE(strongest_edge(*picture, {100, 80}, 0.4, 15));
  }
}

TEST(StrongestEdge, NothingIsFoundFarFromOneOrFromThePicture) {
  const Pyramid picture = upright_edge();
  EXPECT_FALSE(strongest_edge(picture, {70, 80}, 6, 1));
  EXPECT_FALSE(strongest_edge(picture, {-500, -500}, 6, 1));
  EXPECT_FALSE(strongest_edge(picture, {90, 1e6}, 6, 1));
  EXPECT_FALSE(strongest_edge(painted([](cv::Point) { return 0.5f; }, {1, 1}), {0.5, 0.5}, 6, 1));
}

TEST(StrongestEdge, IsFoundOnTheReducedPictureToo) {
  const Pyramid picture = painted([](cv::Point at) { return at.x < 800 ? 0.05f : 0.7f; }, {1600, 400});
  const auto found = strongest_edge(picture, {815, 200}, 24, 0.25);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 800, 4) << "a px of the level that is looked at";
}

Document marked() {
  project::Project project;
  project.features = {test::line("a", {{10, 10}, {50, 10}}, {{110, 10}, {150, 10}}),
                      test::point("b", {53, 10}, {20, 20})};
  return {std::move(project), {200, 200}, {200, 200}};
}

TEST(NearestEnd, IsTheNearestOnThatSideWithinTheRadius) {
  const Document document = marked();
  EXPECT_EQ(nearest_end(document, project::kSource, {51, 10}, 8, -1), cv::Point2d(50, 10));
  EXPECT_EQ(nearest_end(document, project::kSource, {52, 10}, 8, -1), cv::Point2d(53, 10));
  EXPECT_EQ(nearest_end(document, project::kDestination, {52, 10}, 8, -1), std::nullopt);
  EXPECT_EQ(nearest_end(document, project::kDestination, {110, 18}, 8, -1), cv::Point2d(110, 10));
  EXPECT_EQ(nearest_end(document, project::kDestination, {110, 18.01}, 8, -1), std::nullopt);
}

TEST(NearestEnd, LeavesOneFeatureOut) {
  const Document document = marked();
  EXPECT_EQ(nearest_end(document, project::kSource, {50, 10}, 8, 0), cv::Point2d(53, 10));
  EXPECT_EQ(nearest_end(document, project::kSource, {12, 10}, 8, 0), std::nullopt);
}

}  // namespace
}  // namespace morphkit::edit
