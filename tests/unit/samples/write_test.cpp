// A sample as files: it reads back as painted, and no file of the user is lost.

#include "samples/write.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "warp/image/compare.h"

namespace morphkit::samples {
namespace {

namespace fs = std::filesystem;

class Write : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("samples_" + std::to_string(::getpid()) + "_" + info->name());
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

// Small, so that the tests spend no time on painting.
Sample tiny() {
  cv::Mat4b first(3, 4, cv::Vec4b(200, 100, 50, 255));
  first(1, 2) = {10, 20, 30, 128};
  first(0, 0) = {0, 0, 0, 0};
  const cv::Mat4b second(2, 5, cv::Vec4b(1, 2, 3, 255));
  return {"tiny", "Two small pictures", {{"a.png", first}, {"b.png", second}}, "{\"morphkit\": 1}\n"};
}

TEST_F(Write, PutsPicturesAndProjectSideBySide) {
  const Sample sample = tiny();
  EXPECT_EQ(write(sample, folder_ / "made/on/the/way", false), folder_ / "made/on/the/way/tiny.json");
  EXPECT_EQ(text_of(folder_ / "made/on/the/way/tiny.json"), sample.project);
  for (const PaintedPicture& picture : sample.pictures) {
    const warp::Image there = media::read_picture(folder_ / "made/on/the/way" / picture.name).image;
    ASSERT_EQ(there.size(), picture.pixels.size());
    // Far below the step between two 8-bit values.
    EXPECT_TRUE(warp::compare(there, image_of(picture)).within(1e-4)) << picture.name;
  }
}

TEST_F(Write, LeavesFilesThatHoldTheSame) {
  write(tiny(), folder_, false);
  const auto before = fs::last_write_time(folder_ / "a.png");
  EXPECT_NO_THROW(write(tiny(), folder_, false));
  EXPECT_EQ(fs::last_write_time(folder_ / "a.png"), before);
}

TEST_F(Write, RefusesToReplaceSomebodysProject) {
  write(tiny(), folder_, false);
  std::ofstream(folder_ / "tiny.json") << "mine";
  try {
    write(tiny(), folder_, false);
    FAIL() << "replaced it";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
    EXPECT_NE(std::string(error.what()).find("tiny.json"), std::string::npos);
  }
  EXPECT_EQ(text_of(folder_ / "tiny.json"), "mine");
  write(tiny(), folder_, true);
  EXPECT_EQ(text_of(folder_ / "tiny.json"), tiny().project);
}

TEST_F(Write, RefusesToReplaceSomebodysPicture) {
  write(tiny(), folder_, false);
  Sample changed = tiny();
  changed.pictures[0].pixels(2, 2)[1] += 1;
  EXPECT_THROW(write(changed, folder_, false), Error);
  EXPECT_TRUE(warp::compare(media::read_picture(folder_ / "a.png").image, image_of(tiny().pictures[0])).within(1e-4));
  write(changed, folder_, true);
  EXPECT_TRUE(warp::compare(media::read_picture(folder_ / "a.png").image, image_of(changed.pictures[0])).within(1e-4));
}

TEST_F(Write, NamesTheFolderThatCannotBeMade) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "file") << "in the way";
  try {
    write(tiny(), folder_ / "file", false);
    FAIL() << "wrote into a file";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
    EXPECT_EQ(error.place(), (folder_ / "file").string());
  }
}

TEST(ImageOf, IsLinearAndPremultiplied) {
  const warp::Image image = image_of(tiny().pictures[0]);
  EXPECT_EQ(image(0, 0), warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(image(0, 1)[3], 1);
  // IEC 61966-2-1: ((200/255 + 0.055) / 1.055) ^ 2.4
  EXPECT_NEAR(image(0, 1)[0], 0.577580, 1e-5);
  EXPECT_NEAR(image(1, 2)[2], 0.012983 * 128 / 255, 1e-5);
  EXPECT_NEAR(image(1, 2)[3], 128.0 / 255, 1e-6);
}

}  // namespace
}  // namespace morphkit::samples
