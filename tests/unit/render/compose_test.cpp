#include "morph/render/compose.h"

#include <gtest/gtest.h>

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

TEST(LayOver, NothingAColourOrAnImage) {
  const warp::Image half(kSize, warp::Pixel(0.25F, 0, 0, 0.5F));
  warp::Image image = half.clone();
  lay_over(image, {});
  EXPECT_TRUE(same_bits(image, half));
  lay_over(image, warp::Image(1, 1, warp::Pixel(0, 1, 0, 1)));
  EXPECT_EQ(image(5, 5), warp::Pixel(0.25F, 0.5F, 0, 1));
  image = half.clone();
  lay_over(image, warp::Image(kSize, warp::Pixel(0, 0, 1, 1)));
  EXPECT_EQ(image(63, 95), warp::Pixel(0.25F, 0, 0.5F, 1));
}

}  // namespace
}  // namespace morphkit::render
