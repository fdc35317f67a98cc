#include "morph/job/pictures.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/errors.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::job {
namespace {

using test::error_of;
using test::same_bits;

class LoadPictures : public testing::Test {
 protected:
  LoadPictures() {
    project_.pictures[project::kSource].image = folder_ / "a.exr";
    project_.pictures[project::kDestination].image = folder_ / "b.exr";
  }

  void write(const char* name, const warp::Image& image) {
    media::WriteOptions options;
    options.depth = media::Depth::kFloat;
    media::write_image(folder_ / name, image, options);
  }

  test::TemporaryFolder folder_;
  project::Project project_;
};

TEST_F(LoadPictures, KeepsTheOrderOfTheProject) {
  const warp::Image a = test::random_image({8, 6}, 1), b = test::random_image({5, 7}, 2, true);
  write("a.exr", a);
  write("b.exr", b);
  const render::Footage footage = footage_of(load_pictures(project_));
  ASSERT_EQ(footage.pictures.size(), 2U);
  EXPECT_TRUE(same_bits(footage.pictures[0].at(1), a));
  EXPECT_TRUE(same_bits(footage.pictures[1].at(1), b));
  EXPECT_EQ(footage.pictures[1].size, cv::Size(5, 7));
  EXPECT_FALSE(footage.pictures[0].has_alpha);
  EXPECT_TRUE(footage.pictures[1].has_alpha);
  EXPECT_FALSE(footage.background);
}

TEST_F(LoadPictures, LoadsAsManyAsTheProjectHas) {
  for (const char* name : {"a.exr", "b.exr", "c.exr"}) write(name, test::random_image({4, 4}, 3));
  project_.pictures.push_back({"third", folder_ / "c.exr", {}});
  project_.output.background = folder_ / "a.exr";
  const Pictures pictures = load_pictures(project_);
  EXPECT_EQ(pictures.sides.size(), 3U);
  EXPECT_TRUE(pictures.background);
  EXPECT_TRUE(footage_of(pictures).background);
}

TEST_F(LoadPictures, ANumberThatIsNoneMakesAPictureTransparent) {
  warp::Image broken = test::random_image({4, 4}, 4);
  broken(1, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  write("a.exr", broken);
  write("b.exr", test::random_image({4, 4}, 5));
  EXPECT_TRUE(footage_of(load_pictures(project_)).pictures[0].has_alpha);
}

TEST_F(LoadPictures, TellsOfTheFirstBadOne) {
  write("b.exr", test::random_image({4, 4}, 6));
  const Error missing = error_of([&] { load_pictures(project_); });
  EXPECT_EQ(missing.kind(), ErrorKind::kIo);
  EXPECT_EQ(missing.place(), (folder_ / "a.exr").string());
  project_.pictures[project::kDestination].image = folder_ / "c.exr";
  EXPECT_EQ(error_of([&] { load_pictures(project_); }).place(), (folder_ / "a.exr").string());
}

}  // namespace
}  // namespace morphkit::job
