#include "morph/render/renderer.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"
#include "tests/support/threads.h"
#include "tests/unit/render/shows.h"

namespace morphkit::render {
namespace {

using test::dissolved;
using test::expect_shows_what_counts;
using test::frame_at;
using test::line;
using test::pictures;
using test::random_image;
using test::same_bits;
using test::small_project;

const cv::Size kSize(96, 64);

TEST(Renderer, EndsAreThePicturesBitForBit) {
  for (const bool with_alpha : {false, true})
    for (const auto between : {project::Between::kEndpoints, project::Between::kCentre})
      for (const auto filter : {warp::Filter::kNearest, warp::Filter::kBilinear, warp::Filter::kBicubic,
                                warp::Filter::kArea, warp::Filter::kLanczos}) {
        const warp::Image a = random_image(kSize, 1, with_alpha), b = random_image(kSize, 2, with_alpha);
        project::Project project = small_project();
        project.pull.between = between;
        project.warp.filter = filter;
        const Renderer renderer(project, pictures(a, b, with_alpha));
        EXPECT_TRUE(same_bits(frame_at(renderer, 0), a));
        EXPECT_TRUE(same_bits(frame_at(renderer, 1), b));
      }
}

TEST(Renderer, EndsAreExactWithFeaturesThatHaveTheirOwnTimes) {
  const warp::Image a = random_image(kSize, 3), b = random_image(kSize, 4);
  project::Project project = small_project();
  project.features[0].pace.dissolve = motion::Timing{motion::SineEase{}, 0.1, 0.4};
  project.features[2].pace.shape = motion::Timing{motion::ParabolicEase{}, 0.5, 0.5};
  const Renderer renderer(project, pictures(a, b));
  EXPECT_TRUE(same_bits(frame_at(renderer, 0), a));
  EXPECT_TRUE(same_bits(frame_at(renderer, 1), b));
}

TEST(Renderer, IdentityFeaturesGiveTheDissolveExactly) {
  const warp::Image a = random_image(kSize, 5), b = random_image(kSize, 6);
  project::Project project = small_project();
  for (project::Feature& feature : project.features)
    feature.places[project::kDestination] = feature.places[project::kSource];
  const Renderer renderer(project, pictures(a, b));
  for (const double t : {0.125, 0.3, 0.5, 0.9}) {
    EXPECT_TRUE(same_bits(frame_at(renderer, t), dissolved(a, b, static_cast<float>(t))));
  }
}

TEST(Renderer, WithoutFeaturesDissolves) {
  project::Project project;
  const warp::Image a(kSize, warp::Pixel(1, 0, 0, 1)), b(kSize, warp::Pixel(0, 0, 1, 1));
  const warp::Image middle = frame_at(Renderer(project, pictures(a, b)), 0.5);
  EXPECT_EQ(middle(10, 10), warp::Pixel(0.5f, 0, 0.5f, 1));
}

TEST(Renderer, ADoubledPictureIsTheSameMorphBackwards) {
  // Swapping the sides and running backwards gives the same in-between features and so the same maps.
  project::Project project = small_project(), swapped = small_project();
  for (project::Feature& feature : swapped.features)
    std::swap(feature.places[project::kSource], feature.places[project::kDestination]);
  const warp::Image a = random_image(kSize, 7), b = random_image(kSize, 8);
  const Renderer forth(project, pictures(a, b)), back(swapped, pictures(b, a));
  const warp::Map x = forth.map(forth.clock().at(0.25), kSource), y = back.map(back.clock().at(0.75), kDestination);
  EXPECT_LE(cv::norm(x, y, cv::NORM_INF), 1e-3);
}

TEST(Renderer, SameBytesForAnyNumberOfThreads) {
  project::Project project = small_project();
  project.features[0].pace.dissolve = motion::Timing{motion::SineEase{}, 0, 0.5};
  project.output.size = cv::Size(203, 151);
  const Renderer renderer(project, pictures(random_image(kSize, 9, true), random_image({70, 80}, 10, true), true));
  test::set_threads(1);
  const warp::Image one = frame_at(renderer, 0.4);
  for (const int threads : {2, 5}) {
    test::set_threads(threads);
    EXPECT_TRUE(same_bits(frame_at(renderer, 0.4), one)) << threads << " threads";
  }
  test::set_threads(0);
}

TEST(Renderer, ASideShowsAsLongAsTheFrameDependsOnIt) {
  project::Project project = small_project();
  EXPECT_EQ(expect_shows_what_counts(project, kSize), 2) << "the other one at either end";
  for (std::size_t i = 0; i < project.features.size(); ++i)
    project.features[i].pace.dissolve = motion::Timing{motion::LinearEase{}, 0.12 + 0.1 * static_cast<double>(i), 0.4};
  EXPECT_EQ(expect_shows_what_counts(project, kSize), 4);
}

TEST(Renderer, MapIsInPixelsOfThePictureFileWhateverItsSize) {
  // A picture twice the canvas is reduced for sampling; its map still speaks of the file.
  project::Project project;
  project.output.size = cv::Size(48, 32);
  const Renderer renderer(project, pictures(random_image(kSize, 11), random_image({48, 32}, 12)));
  const warp::Map source = renderer.map(renderer.clock().at(0.5), kSource);
  EXPECT_EQ(source(0, 0), warp::MapPoint(1, 1));
  EXPECT_EQ(source(31, 47), warp::MapPoint(95, 63));
  EXPECT_EQ(renderer.map(renderer.clock().at(0.5), kDestination)(31, 47), warp::MapPoint(47.5f, 31.5f));
}

TEST(Renderer, LargePicturesAreAveragedNotSkipped) {
  // A one-pixel checkerboard at half size is grey, without moire.
  warp::Image checks(128, 192);
  for (int y = 0; y < checks.rows; ++y)
    for (int x = 0; x < checks.cols; ++x)
      checks(y, x) = (x + y) % 2 == 0 ? warp::Pixel(1, 1, 1, 1) : warp::Pixel(0, 0, 0, 1);
  project::Project project;
  project.output.size = kSize;
  const warp::Image frame = frame_at(Renderer(project, pictures(checks, checks)), 0);
  for (const warp::Pixel& pixel : frame) ASSERT_NEAR(pixel[0], 0.5, 1e-5);
}

TEST(Renderer, LargeBackgroundsAreAveragedNotSkipped) {
  // A third of the size of a fence of one pixel: every third pixel by itself is black or white.
  warp::Image fence(3 * kSize.height, 3 * kSize.width);
  for (int y = 0; y < fence.rows; ++y)
    for (int x = 0; x < fence.cols; ++x) fence(y, x) = x % 2 == 0 ? warp::Pixel(1, 1, 1, 1) : warp::Pixel(0, 0, 0, 1);
  const warp::Image nothing(kSize, warp::Pixel(0, 0, 0, 0));
  Footage both = pictures(nothing, nothing, true);
  both.background = in_memory(fence);
  project::Project project;
  project.output.background = "fence.png";
  const warp::Image frame = frame_at(Renderer(project, both), 0.5);
  for (const warp::Pixel& pixel : frame) ASSERT_NEAR(pixel[0], 0.5, 0.25);
}

TEST(Renderer, LocalDissolveFollowsTheNearestFeature) {
  project::Project project;
  project.pull.a = 0.01;
  project.features = {line("left", {{8, 8}, {8, 56}}, {{8, 8}, {8, 56}}),
                      line("right", {{88, 8}, {88, 56}}, {{88, 8}, {88, 56}})};
  project.features[0].pace.dissolve = motion::Timing{motion::StepEase{0.1}, 0, 1};
  project.features[1].pace.dissolve = motion::Timing{motion::StepEase{0.9}, 0, 1};
  const warp::Image a(kSize, warp::Pixel(0, 0, 0, 1)), b(kSize, warp::Pixel(1, 1, 1, 1));
  const warp::Image frame = frame_at(Renderer(project, pictures(a, b)), 0.5);
  EXPECT_GT(frame(32, 8)[0], 0.99f);
  EXPECT_LT(frame(32, 87)[0], 0.01f);
  for (int x = 9; x < 88; ++x) EXPECT_LE(frame(32, x)[0], frame(32, x - 1)[0]);
}

TEST(Renderer, LettersboxesAreTransparentOrBackground) {
  project::Project project;
  project.output.size = cv::Size(96, 96);
  project.output.fit = project::Fit::kContain;
  const warp::Image white(kSize, warp::Pixel(1, 1, 1, 1));
  const Renderer clear(project, pictures(white, white));
  EXPECT_TRUE(clear.has_alpha());
  EXPECT_EQ(frame_at(clear, 0.5)(2, 50), warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(frame_at(clear, 0.5)(48, 50), warp::Pixel(1, 1, 1, 1));
  project.output.background = project::Color{1, 0, 0, 1};
  const Renderer red(project, pictures(white, white));
  EXPECT_FALSE(red.has_alpha());
  EXPECT_EQ(frame_at(red, 0.5)(2, 50), warp::Pixel(1, 0, 0, 1));
}

TEST(Renderer, TimeRunsFromTheFirstFrameToTheLast) {
  project::Project project;
  project.output.frames = 5;
  project.output.start = 101;
  const warp::Image white(kSize, warp::Pixel(1, 1, 1, 1));
  const Renderer renderer(project, pictures(white, white));
  EXPECT_EQ(renderer.time_of(101).t, 0);
  EXPECT_EQ(renderer.time_of(103).t, 0.5);
  EXPECT_EQ(renderer.time_of(105).t, 1);
  project.output.frames = 1;
  EXPECT_EQ(Renderer(project, pictures(white, white)).time_of(101).t, 0);
}

}  // namespace
}  // namespace morphkit::render
