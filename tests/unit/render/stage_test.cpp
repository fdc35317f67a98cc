#include "morph/render/stage.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::pictures;
using test::random_image;
using test::same_bits;

TEST(Stage, TheCanvasIsTheOutputOrTheFirstPicture) {
  project::Project project;
  EXPECT_EQ(canvas_size(project, {96, 64}), cv::Size(96, 64));
  project.output.size = cv::Size(20, 30);
  EXPECT_EQ(canvas_size(project, {96, 64}), cv::Size(20, 30));
}

TEST(Stage, APictureOfTheCanvasSizeIsHeldAsItIs) {
  const warp::Image a = random_image({96, 64}, 1);
  const Stage stage = make_stage({}, pictures(a, random_image({96, 64}, 2)));
  EXPECT_EQ(stage.size, cv::Size(96, 64));
  EXPECT_TRUE(same_bits(stage.sides[kSource].image, a));
  EXPECT_TRUE(stage.sides[kSource].file.is_identity());
  EXPECT_TRUE(stage.sides[kSource].held.is_identity());
  EXPECT_EQ(stage.sides[kSource].border, warp::Border::kClamp);
  EXPECT_TRUE(stage.behind.empty());
}

TEST(Stage, ALargePictureIsReducedOnceAndBothPlacementsAgree) {
  project::Project project;
  project.output.size = cv::Size(48, 32);
  const Stage stage = make_stage(project, pictures(random_image({96, 64}, 1), random_image({24, 16}, 2)));
  const StageSide &large = stage.sides[kSource], &small = stage.sides[kDestination];
  EXPECT_EQ(large.image.size(), cv::Size(48, 32));
  EXPECT_EQ(large.file_size, cv::Size(96, 64));
  EXPECT_EQ(large.file.to_canvas({96, 64}), large.held.to_canvas({48, 32}));
  EXPECT_EQ(small.image.size(), cv::Size(24, 16)) << "a small one is never enlarged";
  EXPECT_EQ(small.file.to_canvas({24, 16}), cv::Point2d(48, 32));
}

TEST(Stage, APictureThatDoesNotCoverTheCanvasEndsAtItsBorder) {
  project::Project project;
  project.output.size = cv::Size(96, 96);
  project.output.fit = project::Fit::kContain;
  const Footage both = pictures(random_image({96, 64}, 1), random_image({96, 96}, 2));
  EXPECT_EQ(make_stage(project, both).sides[kSource].border, warp::Border::kTransparent);
  EXPECT_EQ(make_stage(project, both).sides[kDestination].border, warp::Border::kClamp);
  project.warp.border = warp::Border::kMirror;
  EXPECT_EQ(make_stage(project, both).sides[kSource].border, warp::Border::kMirror);
}

TEST(Stage, AViewMovesAndMagnifiesTheCanvas) {
  const CanvasView view{{40, 20}, 2, {10, 6}};
  const Stage stage = make_stage({}, pictures(random_image({96, 64}, 1), random_image({96, 64}, 2)), view);
  EXPECT_EQ(stage.size, cv::Size(40, 20));
  EXPECT_EQ(stage.unit, 0.5);
  EXPECT_EQ(stage.sides[kSource].file.to_canvas({10, 6}), cv::Point2d(0, 0));
  EXPECT_EQ(stage.sides[kSource].file.to_canvas({20, 16}), cv::Point2d(20, 20));
}

TEST(Stage, ItHasAPictureForEachOfTheProject) {
  Footage one = pictures(random_image({9, 9}, 1), random_image({9, 9}, 2));
  one.pictures.pop_back();
  EXPECT_THROW(make_stage({}, one), std::invalid_argument);
}

TEST(Stage, SidesHaveNames) {
  EXPECT_STREQ(name_of(kSource), "source");
  EXPECT_STREQ(name_of(kDestination), "destination");
}

}  // namespace
}  // namespace morphkit::render
