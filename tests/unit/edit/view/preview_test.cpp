// Tests cli/edit/view/preview_thread.cpp.

#include "cli/edit/view/preview.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cli/edit/view/preview_thread.h"
#include "cli/edit/view/screen.h"
#include "morph/render/renderer.h"
#include "tests/support/pictures.h"

namespace morphkit::edit {
namespace {

const cv::Size kSize(96, 64);

/// Without detail beyond what half the size can hold.
warp::Image smooth_image(cv::Size size, unsigned seed) {
  warp::Image image;
  cv::resize(test::random_image({4, 3}, seed), image, size, 0, 0, cv::INTER_LINEAR);
  return image;
}

class PreviewTest : public testing::Test {
 protected:
  PreviewTest() { project_ = test::small_project(); }

  void use(const warp::Image& source, const warp::Image& destination) {
    pictures_ = test::pictures(source, destination);
    source_ = std::make_unique<Pyramid>(source);
    destination_ = std::make_unique<Pyramid>(destination);
  }

  /// All of the canvas at zoom 1.
  PreviewRequest whole(double t, Show show = Show::kDissolve) const {
    PreviewRequest request;
    request.project = std::make_shared<project::Project>(project_);
    request.t = t;
    request.show = show;
    request.size = render::canvas_size(project_, source_->size());
    request.view = {1, cv::Point2d(request.size.width, request.size.height) / 2.0};
    return request;
  }

  PreviewPicture rendered(const PreviewRequest& request, int reduction = 1) const {
    PreviewPicture picture = PreviewRenderer(*source_, *destination_).render(request, reduction);
    EXPECT_EQ(picture.problem, "");
    return picture;
  }

  warp::Image picture(SideIndex side) const { return pictures_.pictures[side].at(1); }
  render::Renderer renderer() const { return render::Renderer(project_, pictures_, {true}); }

  static double greatest_difference(const cv::Mat3b& a, const cv::Mat3b& b) {
    EXPECT_EQ(a.size(), b.size());
    return a.size() == b.size() ? cv::norm(a, b, cv::NORM_INF) : 255;
  }

  project::Project project_;
  render::Footage pictures_;
  std::unique_ptr<Pyramid> source_, destination_;
};

TEST_F(PreviewTest, AllOfTheCanvasAtItsSizeIsTheFrame) {
  use(test::random_image(kSize, 1), test::random_image({80, 70}, 2));
  for (const auto fit : {project::Fit::kCover, project::Fit::kContain, project::Fit::kNone}) {
    project_.output.fit = fit;
    for (const double t : {0.0, 0.4, 1.0})
      EXPECT_LE(greatest_difference(rendered(whole(t)).image, to_screen(test::frame_at(renderer(), t))), 1)
          << "t " << t;
  }
}

TEST_F(PreviewTest, ABackgroundColourLiesUnderTheFrame) {
  use(test::random_image(kSize, 3), test::random_image({30, 64}, 4));
  project_.output.fit = project::Fit::kNone;
  project_.output.background = project::Color{0.9, 0.2, 0.4, 0.8};
  EXPECT_LE(greatest_difference(rendered(whole(0.7)).image, to_screen(test::frame_at(renderer(), 0.7))), 1);
}

TEST_F(PreviewTest, AMeshIsRenderedToo) {
  use(test::random_image(kSize, 5), test::random_image(kSize, 6));
  project_.features.clear();
  project_.mesh = project::Mesh{4, 3, {{}, {}}, {}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      project_.mesh->vertices[project::kSource].emplace_back(x * 32, y * 32);
      project_.mesh->vertices[project::kDestination].emplace_back(x * 32 + (x == 1 ? 6 : 0),
                                                                  y * 32 - (y == 1 && x % 3 != 0 ? 5 : 0));
    }
  EXPECT_LE(greatest_difference(rendered(whole(0.5)).image, to_screen(test::frame_at(renderer(), 0.5))), 1);
}

TEST_F(PreviewTest, ABackgroundPictureLiesUnderTheFrame) {
  use(smooth_image(kSize, 31), smooth_image({30, 64}, 32));
  const warp::Image behind = smooth_image({120, 90}, 33);
  pictures_.background = render::in_memory(behind);
  project_.output.fit = project::Fit::kNone;
  project_.output.background = std::filesystem::path("behind.png");
  const Pyramid background(behind);
  const PreviewRequest request = whole(0.7);
  const PreviewPicture picture = PreviewRenderer(*source_, *destination_, &background).render(request);
  EXPECT_EQ(picture.problem, "");
  EXPECT_LE(greatest_difference(picture.image, to_screen(test::frame_at(renderer(), 0.7))), 1);
}

TEST_F(PreviewTest, ASideUnderAMeshIsDrawnInTwoPassesAsInTheFrame) {
  use(test::random_image(kSize, 34), test::random_image(kSize, 35));
  project_.features.clear();
  project_.mesh = project::Mesh{2, 2, {{}, {}}, {}};
  project_.mesh->vertices[project::kDestination] = {{0, 0}, {96, 0}, {0, 64}, {96, 64}};
  project_.warp.filter = warp::Filter::kNearest;
  project_.pace.dissolve = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  EXPECT_EQ(greatest_difference(rendered(whole(0.4, Show::kSource)).image, to_screen(test::frame_at(renderer(), 0.4))),
            0);
}

TEST_F(PreviewTest, APartOfTheCanvasIsThatPartOfTheFrame) {
  use(test::random_image(kSize, 7), test::random_image(kSize, 8));
  PreviewRequest request = whole(0.5);
  request.size = {40, 30};
  request.view.centre = {50, 35};  // shows 30..70, 20..50
  const cv::Mat3b frame = to_screen(test::frame_at(renderer(), 0.5));
  EXPECT_LE(greatest_difference(rendered(request).image, frame(cv::Rect(30, 20, 40, 30))), 1);
}

TEST_F(PreviewTest, ASmallerOrLargerViewShowsTheSameWarp) {
  // The weights, and the lines that curves are made of, must not depend on how the canvas is looked at.
  const cv::Size size(384, 256);
  use(smooth_image(size, 9), smooth_image(size, 10));
  project_.pull.a = 5;
  project_.pull.p = 0.5;
  project_.features[0].pull.b = 1.2;
  project_.features[1].pull.p = 1;
  for (project::Feature& feature : project_.features)
    for (auto* points : {&feature.places[project::kSource], &feature.places[project::kDestination]})
      for (cv::Point2d& point : *points) point *= 4;
  const warp::Image frame = test::frame_at(renderer(), 0.5);
  for (const double zoom : {0.5, 0.25, 2.0}) {
    PreviewRequest request = whole(0.5);
    request.view.zoom = zoom;
    request.size = {static_cast<int>(size.width * zoom), static_cast<int>(size.height * zoom)};
    warp::Image expected;
    cv::resize(frame, expected, request.size, 0, 0, zoom < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    EXPECT_LE(greatest_difference(rendered(request).image, to_screen(expected)), 4) << "zoom " << zoom;
  }
}

TEST_F(PreviewTest, ADraftIsTheSamePictureWithFewerPixels) {
  use(smooth_image(kSize, 11), smooth_image(kSize, 12));
  const PreviewPicture full = rendered(whole(0.5)), draft = rendered(whole(0.5), 2);
  EXPECT_FALSE(full.draft);
  EXPECT_TRUE(draft.draft);
  ASSERT_EQ(draft.image.size(), cv::Size(48, 32));
  cv::Mat3b expected;
  cv::resize(full.image, expected, draft.image.size(), 0, 0, cv::INTER_AREA);
  EXPECT_LE(greatest_difference(draft.image, expected), 6);
}

TEST_F(PreviewTest, WhatIsKeptNeverChangesThePicture) {
  use(test::random_image(kSize, 13), test::random_image({50, 64}, 14));
  PreviewRenderer keeps(*source_, *destination_);
  std::vector<PreviewRequest> requests{whole(0.3), whole(0.6)};
  project_.output.fit = project::Fit::kContain;
  requests.push_back(whole(0.6));
  project_.warp.border = warp::Border::kTransparent;
  requests.push_back(whole(0.6));
  project_.output.size = cv::Size(70, 70);
  requests.push_back(whole(0.6));
  requests.push_back(requests.back());
  requests.back().view.zoom = 0.4;
  requests.push_back(requests.front());
  for (const PreviewRequest& request : requests)
    for (const int reduction : {3, 1})
      EXPECT_EQ(greatest_difference(keeps.render(request, reduction).image, rendered(request, reduction).image), 0);
}

TEST_F(PreviewTest, SidesAreWhatTheDissolveAndTheDifferenceAreMadeOf) {
  use(test::random_image(kSize, 15), test::random_image(kSize, 16));
  EXPECT_LE(greatest_difference(rendered(whole(0, Show::kSource)).image, to_screen(picture(project::kSource))), 1);
  EXPECT_LE(
      greatest_difference(rendered(whole(1, Show::kDestination)).image, to_screen(picture(project::kDestination))), 1);
  const cv::Mat3b source = rendered(whole(0.5, Show::kSource)).image;
  const cv::Mat3b destination = rendered(whole(0.5, Show::kDestination)).image;
  const cv::Mat3b frame = rendered(whole(0.5)).image;
  const cv::Mat3b difference = rendered(whole(0.5, Show::kDifference)).image;
  for (int y = 0; y < frame.rows; ++y)
    for (int x = 0; x < frame.cols; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto [low, high] = std::minmax({int{source(y, x)[c]}, int{destination(y, x)[c]}});
        ASSERT_GE(frame(y, x)[c], low - 1);
        ASSERT_LE(frame(y, x)[c], high + 1);
        ASSERT_EQ(difference(y, x)[c], high - low);
      }
}

TEST_F(PreviewTest, ReducedSidesAreReducedFrames) {
  const cv::Size size(600, 400);
  use(smooth_image(size, 17), smooth_image(size, 18));
  PreviewRequest request = whole(0, Show::kSource);
  request.view.zoom = 0.25;
  request.size = {150, 100};
  warp::Image expected;
  cv::resize(picture(project::kSource), expected, request.size, 0, 0, cv::INTER_AREA);
  EXPECT_LE(greatest_difference(rendered(request).image, to_screen(expected)), 1);
}

TEST_F(PreviewTest, AGridOfCellsIsDrawn) {
  use(warp::Image(100, 200, warp::Pixel(0, 0, 0, 1)), warp::Image(100, 200, warp::Pixel(0, 0, 0, 1)));
  project_.features.clear();
  const cv::Mat3b grid = rendered(whole(0.5, Show::kGrid)).image;  // a line each 10 px
  EXPECT_GT(grid(45, 70)[0], 60);
  EXPECT_GT(grid(50, 75)[0], 60);
  EXPECT_LT(grid(45, 75)[0], 5);
}

TEST_F(PreviewTest, FoldsArePaintedAndCounted) {
  use(warp::Image(kSize, warp::Pixel(0, 0, 0, 1)), warp::Image(kSize, warp::Pixel(0, 0, 0, 1)));
  PreviewRequest request = whole(0.5);
  EXPECT_TRUE(std::isnan(rendered(request).fold_share));

  project_.features = {test::line("still", {{30, 10}, {30, 50}}, {{30, 10}, {30, 50}})};
  request = whole(0.5);
  request.folds = true;
  EXPECT_EQ(rendered(request).fold_share, 0);
  EXPECT_EQ(cv::norm(rendered(request).image, cv::NORM_INF), 0);

  // Two lines change places.
  project_.features = {test::line("left", {{30, 10}, {30, 50}}, {{60, 10}, {60, 50}}),
                       test::line("right", {{60, 10}, {60, 50}}, {{30, 10}, {30, 50}})};
  for (const auto& [t, show] : {std::pair(0.4, Show::kDissolve), std::pair(0.0, Show::kDestination),
                                std::pair(1.0, Show::kSource), std::pair(0.4, Show::kDifference)}) {
    request = whole(t, show);
    request.folds = true;
    const PreviewPicture picture = rendered(request);
    std::vector<cv::Mat1b> planes;
    cv::split(picture.image, planes);
    const double red = static_cast<double>(cv::countNonZero(planes[2] > planes[0] + 50)) / kSize.area();
    EXPECT_GT(picture.fold_share, 0) << t;
    EXPECT_NEAR(red, picture.fold_share, 0.01) << t;
  }
  for (const auto& [t, show] : {std::pair(0.0, Show::kDissolve), std::pair(1.0, Show::kDissolve),
                                std::pair(0.0, Show::kSource), std::pair(1.0, Show::kDestination)}) {
    request = whole(t, show);
    request.folds = true;
    EXPECT_EQ(rendered(request).fold_share, 0) << t;  // the fold is in the side that does not show
  }
}

TEST_F(PreviewTest, WhatCannotBeRenderedIsAProblemAndNoPicture) {
  use(test::random_image(kSize, 19), test::random_image(kSize, 20));
  project_.features.clear();
  project_.mesh = project::Mesh{2, 2, {{{0, 0}, {500, 0}, {0, 64}, {500, 64}}, {}}, {}};
  PreviewRequest request = whole(0.5);
  request.number = 7;
  PreviewRenderer renders(*source_, *destination_);
  const PreviewPicture picture = renders.render(request);
  EXPECT_NE(picture.problem, "");
  EXPECT_TRUE(picture.image.empty());
  EXPECT_EQ(picture.number, 7U);
  project_.mesh.reset();
  EXPECT_EQ(renders.render(whole(0.5)).problem, "");
}

TEST_F(PreviewTest, TheLastRequestIsAlwaysAnswered) {
  use(test::random_image(kSize, 21), test::random_image(kSize, 22));
  PreviewThread thread(*source_, *destination_);
  std::uint64_t newest = 0;
  for (std::uint64_t number = 1; number <= 200; ++number) {
    PreviewRequest request = whole(static_cast<double>(number) / 200);
    request.number = number;
    thread.request(request);
    if (number % 50 == 0) thread.finish();
    if (const auto picture = thread.take()) {
      EXPECT_GE(picture->number, newest);
      EXPECT_LE(picture->number, number);
      newest = picture->number;
      if (number % 50 == 0) {
        EXPECT_EQ(newest, number);
        EXPECT_FALSE(picture->draft);
        EXPECT_EQ(greatest_difference(picture->image, rendered(request).image), 0);
      }
    }
  }
  EXPECT_EQ(newest, 200U);
  EXPECT_FALSE(thread.take());
}

TEST_F(PreviewTest, AThreadMayEndWithWorkLeft) {
  use(test::random_image(kSize, 23), test::random_image(kSize, 24));
  for (int i = 0; i < 20; ++i) {
    PreviewThread thread(*source_, *destination_);
    for (int j = 0; j < i; ++j) thread.request(whole(0.5));
  }
}

}  // namespace
}  // namespace morphkit::edit
