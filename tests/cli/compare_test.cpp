// Tests cli/cmd_compare.cpp and cli/run_compare.cpp.

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/commands.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

TEST(Compare, EqualPicturesAreIdentical) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const RunResult result = run_morphkit({"compare", a, a});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "identical bit for bit")) << result.out;
}

TEST(Compare, NamesTheWorstPixelAndHonoursTheTolerance) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const RunResult result = run_morphkit({"compare", a, b});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.out, "worst pixel       x 11 y 7")) << result.out;
  EXPECT_TRUE(contains(result.out, "1 of 1200")) << result.out;
  EXPECT_EQ(run_morphkit({"compare", a, b, "--tolerance", "0.005"}).exit_code, 0);
  EXPECT_EQ(run_morphkit({"compare", a, b, "--tolerance", "0.003"}).exit_code, 5);
}

TEST(Compare, WritesThePictureOfTheDifferenceAndDoesNotReplaceOne) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const std::string difference = (folder / "d.png").string();
  const std::vector<std::string> command = {"compare", a, b, "--difference", difference, "--gain", "255"};
  EXPECT_EQ(run_morphkit(command).exit_code, 5);
  const warp::Image picture = media::read_picture(difference).image;
  EXPECT_EQ(picture(7, 11), warp::Pixel(1, 0, 0, 1));
  EXPECT_EQ(picture(7, 12), warp::Pixel(0, 0, 0, 1));
  EXPECT_EQ(run_morphkit(command).exit_code, 4);
  std::vector<std::string> again = command;
  again.push_back("-y");
  EXPECT_EQ(run_morphkit(again).exit_code, 5);
}

TEST(Compare, UnequalSizesAreADifference) {
  TemporaryFolder folder;
  const RunResult result =
      run_morphkit({"compare", write_gradient(folder, "a.png"), write_gradient(folder, "b.png", {41, 30})});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.out, "sizes differ")) << result.out;
}

TEST(Compare, NotANumberNeverPasses) {
  TemporaryFolder folder;
  warp::Image image = gradient({8, 8});
  image(0, 0)[2] = std::numeric_limits<float>::quiet_NaN();
  media::WriteOptions options;
  options.depth = media::Depth::kFloat;
  media::write_image(folder / "a.exr", image, options);
  const std::string a = (folder / "a.exr").string();
  const RunResult result = run_morphkit({"compare", a, a, "--tolerance", "1000"});
  EXPECT_EQ(result.exit_code, 5) << result.out;
  EXPECT_TRUE(contains(result.out, "not finite")) << result.out;
}

TEST(Compare, PrintsJson) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const RunResult same = run_morphkit({"compare", a, a, "--json"});
  EXPECT_TRUE(contains(same.out, "\"identical\": true")) << same.out;
  EXPECT_TRUE(contains(same.out, "\"psnr_db\": null")) << same.out;
  const RunResult other = run_morphkit({"compare", a, b, "--json"});
  EXPECT_EQ(other.exit_code, 5);
  EXPECT_TRUE(contains(other.out, "\"differing_pixels\": 1,")) << other.out;
}

TEST(Compare, RefusesWrongUse) {
  expect_usage_error(run_morphkit({"compare", "a.png"}), "B is required");
  expect_usage_error(run_morphkit({"compare", "a", "b", "c"}), "unexpected argument 'c'");
  expect_usage_error(run_morphkit({"compare", "a", "b", "--tolerance", "-1"}), "'-1' is not a number of at least 0");
  expect_usage_error(run_morphkit({"compare", "a", "b", "--gain", "nan"}), "'nan' is not a number of at least 0");
  EXPECT_EQ(run_morphkit({"compare", "/nonexistent/a.png", "/nonexistent/b.png"}).exit_code, 4);
}

}  // namespace
}  // namespace morphkit::test
