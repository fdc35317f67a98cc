#include "morph/render/line_warper.h"

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::pictures;
using test::random_image;
using test::small_project;

const cv::Size kSize(96, 64);

TEST(LineWarper, BandsAreRowsOfTheWholeMap) {
  const Renderer renderer(small_project(), pictures(random_image(kSize, 1), random_image({80, 70}, 2)));
  const auto warper = renderer.warper(renderer.clock().at(0.4));
  for (const Pixels pixels : {Pixels::kHeld, Pixels::kFile}) {
    std::vector<warp::Map> maps{warp::Map(20, kSize.width), warp::Map(20, kSize.width)};
    warper->positions(32, maps, pixels, {});
    for (const SideIndex side : {kSource, kDestination}) {
      const warp::Map whole = warper->map(side, pixels);
      EXPECT_EQ(cv::norm(maps[side], whole.rowRange(32, 52), cv::NORM_INF), 0);
    }
  }
}

TEST(LineWarper, HeldPixelsAreThoseOfThePictureInMemory) {
  project::Project project = small_project();
  project.output.size = kSize;
  const cv::Size large(kSize.width * 2, kSize.height * 2);
  const Renderer renderer(project, pictures(random_image(large, 3), random_image(kSize, 4)));
  ASSERT_EQ(renderer.stage().sides[kSource].image.size(), kSize);
  const warp::Map held = renderer.map(renderer.clock().at(0.5), kSource, Pixels::kHeld),
                  file = renderer.map(renderer.clock().at(0.5), kSource);
  EXPECT_LE(cv::norm(warp::Map(held * 2), file, cv::NORM_INF), 1e-3);
}

TEST(LineWarper, TheDissolveIsThatOfTheNearestFeatures) {
  project::Project project = small_project();
  project.features[0].pace.dissolve = motion::Timing{motion::LinearEase{}, 0, 0.5};
  const Renderer renderer(project, pictures(random_image(kSize, 5), random_image(kSize, 6)));
  const auto warper = renderer.warper(renderer.clock().at(0.5));
  EXPECT_EQ(warper->weights()[kDestination].least, 0.5);
  EXPECT_EQ(warper->weights()[kDestination].most, 1);
  std::vector<warp::Map> maps{warp::Map(kSize), warp::Map(kSize)};
  cv::Mat1f dissolve(kSize);
  warper->positions(0, maps, Pixels::kHeld, {&dissolve, 1});
  double least = 0, most = 0;
  cv::minMaxLoc(dissolve, &least, &most);
  EXPECT_GE(least, 0.5);
  EXPECT_LE(most, 1);
  EXPECT_GT(dissolve(15, 45), dissolve(50, 50)) << "near the brow, far from it";
}

TEST(LineWarper, CarriesAPointFromAnyPictureToAnyOther) {
  project::Project project;
  project.pull.a = 0;
  project.output.size = kSize;
  project.features = {test::line("l", {{20, 20}, {60, 20}}, {{60, 60}, {60, 100}})};
  const cv::Size large(kSize.width * 2, kSize.height * 2);
  const Renderer renderer(project, pictures(random_image(kSize, 7), random_image(large, 8)));
  for (const double t : {0.0, 0.3, 1.0}) {
    const auto warper = renderer.warper(renderer.clock().at(t));
    const auto there = warper->carry(kSource, kDestination, {40, 20}),
               back = warper->carry(kDestination, kSource, {60, 80});
    ASSERT_TRUE(there && back);
    EXPECT_LE(cv::norm(*there - cv::Point2d(60, 80)), 1e-3);
    EXPECT_LE(cv::norm(*back - cv::Point2d(40, 20)), 1e-3);
    EXPECT_LE(cv::norm(*warper->carry(kSource, kSource, {33, 44}) - cv::Point2d(33, 44)), 1e-3);
  }
}

TEST(LineWarper, WithoutFeaturesCarriesNothing) {
  const Renderer renderer({}, pictures(random_image(kSize, 9), random_image(kSize, 10)));
  EXPECT_FALSE(renderer.warper(renderer.clock().at(0.5))->carry(kSource, kDestination, {4, 5}));
}

TEST(LineWarper, HasTheProblemsOfItsMoment) {
  project::Project project;  // two neighbours change places
  project.features = {test::line("left", {{40, 10}, {40, 54}}, {{56, 10}, {56, 54}}),
                      test::line("right", {{56, 10}, {56, 54}}, {{40, 10}, {40, 54}})};
  const Renderer renderer(project, pictures(random_image(kSize, 11), random_image(kSize, 12)));
  EXPECT_TRUE(renderer.warper(renderer.clock().at(0))->problems().empty());
  const std::vector<Finding> found = renderer.warper(renderer.clock().at(0.25))->problems();
  ASSERT_EQ(found.size(), 1u) << "only the destination has crossed the middle";
  EXPECT_EQ(found[0].kind, Finding::Kind::kFold);
  EXPECT_EQ(found[0].where, "destination");
  EXPECT_EQ(found[0].t, 0.25);
  EXPECT_EQ(found[0].features.size(), 2u);
}

}  // namespace
}  // namespace morphkit::render
