#include "morph/render/compose.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "morph/render/line_warper.h"
#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::frame_at;
using test::pictures;
using test::random_image;
using test::same_bits;
using test::small_project;

const cv::Size kSize(96, 64);

project::Project mesh_project() {
  project::Project project;
  project.mesh = project::Mesh{3, 3, {{}, {}}, {}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      project.mesh->vertices[kSource].emplace_back(x * 48, y * 32);
      project.mesh->vertices[kDestination].emplace_back(x * 48 + (x == 1 ? 9 : 0), y * 32 - (y == 1 ? 6 : 0));
    }
  return project;
}

TEST(Compose, ASideAloneIsTheFrameWithoutTheOther) {
  for (project::Project project : {small_project(), mesh_project()}) {
    // The source shows alone until the middle, while the shape moves.
    project.pace.dissolve = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
    const Renderer renderer(project, pictures(random_image(kSize, 1), random_image(kSize, 2)));
    EXPECT_TRUE(same_bits(renderer.side(renderer.clock().at(0.4), kSource), frame_at(renderer, 0.4)));
    EXPECT_FALSE(same_bits(renderer.side(renderer.clock().at(0.4), kDestination), frame_at(renderer, 0.4)));
    EXPECT_TRUE(same_bits(renderer.side(renderer.clock().at(1), kDestination), frame_at(renderer, 1)));
  }
}

TEST(Compose, AFrameIsTheMixOfItsSides) {
  for (const project::Project& project : {small_project(), mesh_project()}) {
    const Renderer renderer(project, pictures(random_image(kSize, 3), random_image(kSize, 4)));
    const warp::Image mixed = test::dissolved(renderer.side(renderer.clock().at(0.25), kSource),
                                              renderer.side(renderer.clock().at(0.25), kDestination), 0.25F);
    EXPECT_LE(cv::norm(mixed, frame_at(renderer, 0.25), cv::NORM_INF), 1e-6);
  }
}

TEST(Compose, AMapHasThePositionsOfItsBands) {
  for (const project::Project& project : {small_project(), mesh_project()}) {
    const Renderer renderer(project, pictures(random_image(kSize, 5), random_image(kSize, 6)));
    const auto warper = renderer.warper(renderer.clock().at(0.5));
    std::vector<warp::Map> maps{warp::Map(kSize), warp::Map(kSize)};
    warper->positions(0, maps, Pixels::kFile, {});
    for (const SideIndex side : {kSource, kDestination})
      EXPECT_LE(cv::norm(maps[side], renderer.map(renderer.clock().at(0.5), side), cv::NORM_INF), 1e-4);
  }
}

/// A red, a green and a blue picture, and a moment with these weights of their colours for each feature.
struct ThreePictures {
  ThreePictures(std::vector<project::MomentFeature> features, const std::vector<std::vector<double>>& dissolve) {
    stage.size = kSize;
    for (int i = 0; i < 3; ++i) {
      StageSide& side = stage.sides.emplace_back();
      side.image = warp::Image(kSize, warp::Pixel(i == 0, i == 1, i == 2, 1));
      side.file_size = kSize;
    }
    for (const std::vector<double>& weights : dissolve)
      moment.feature_weights.push_back({.shape = {0.25, 0.25, 0.5}, .dissolve = weights});
    moment.whole = moment.feature_weights.front();
    moment.features = std::make_shared<const std::vector<project::MomentFeature>>(std::move(features));
  }

  warp::Image frame() const {
    const std::vector<Placement> placements(3);
    const auto lines = std::make_shared<const std::vector<FeatureLine>>(feature_lines(*moment.features, placements));
    const LineWarper warper(moment, lines, ranges_of(moment.feature_weights), stage);
    return compose(stage, warper, warp::Filter::kBilinear, project::Blend::kLinear);
  }

  Stage stage;
  project::Moment moment;
};

TEST(Compose, ThreePicturesMixByTheirWeights) {
  const auto frame_of = [](const std::vector<double>& weights) { return ThreePictures({}, {weights}).frame()(20, 30); };
  EXPECT_LE(cv::norm(frame_of({0.2, 0.3, 0.5}) - warp::Pixel(0.2F, 0.3F, 0.5F, 1)), 1e-6);
  EXPECT_LE(cv::norm(frame_of({0, 0.75, 0.25}) - warp::Pixel(0, 0.75F, 0.25F, 1)), 1e-6);
  EXPECT_EQ(frame_of({1, 0, 0}), warp::Pixel(1, 0, 0, 1));
  EXPECT_EQ(frame_of({0, 0, 1}), warp::Pixel(0, 0, 1, 1));
}

TEST(Compose, ThreePicturesMixAsTheNearestFeatureSays) {
  const auto upright = [](const char* id, double x) {
    project::MomentFeature feature;
    feature.id = id;
    feature.places.assign(3, {{x, 4}, {x, 60}});
    feature.weight.a = 0.01;
    return feature;
  };
  const ThreePictures three({upright("left", 8.5), upright("middle", 48.5), upright("right", 88.5)},
                            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const warp::Image frame = three.frame();
  EXPECT_GT(frame(32, 8)[0], 0.99F);
  EXPECT_GT(frame(32, 48)[1], 0.99F);
  EXPECT_GT(frame(32, 88)[2], 0.99F);
  for (const warp::Pixel& pixel : frame) ASSERT_NEAR(pixel[0] + pixel[1] + pixel[2], 1, 1e-5);
}

TEST(LayOver, NothingAColourOrAnImage) {
  const warp::Image half(kSize, warp::Pixel(0.25F, 0, 0, 0.5F));
  warp::Image image = half.clone();
  composite_over(image, {});
  EXPECT_TRUE(same_bits(image, half));
  composite_over(image, warp::Image(1, 1, warp::Pixel(0, 1, 0, 1)));
  EXPECT_EQ(image(5, 5), warp::Pixel(0.25F, 0.5F, 0, 1));
  image = half.clone();
  composite_over(image, warp::Image(kSize, warp::Pixel(0, 0, 1, 1)));
  EXPECT_EQ(image(63, 95), warp::Pixel(0.25F, 0, 0.5F, 1));
}

}  // namespace
}  // namespace morphkit::render
