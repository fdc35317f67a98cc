// Every sample, rendered the whole way from its files to 8-bit pictures, against the pictures that people have looked
// at. Renew with scripts/renew-goldens.sh.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/check.h"
#include "morph/render/renderer.h"
#include "samples/samples.h"
#include "samples/write.h"
#include "tests/support/temporary_folder.h"
#include "warp/compare.h"

namespace morphkit {
namespace {

namespace fs = std::filesystem;

/// The same for every golden picture: instruction sets may differ by kFieldTolerancePx, which moves an 8-bit value by a
/// step, and the rounding of two such values by one more.
constexpr double kTolerance = 2.0 / 255;

/// Long side of golden pictures, px: large enough to see, small enough for the repository.
constexpr int kLongSide = 320;

const fs::path kExpected = fs::path(MORPHKIT_SOURCE_DIR) / "tests/golden/expected";
const fs::path kReport = fs::path(MORPHKIT_BINARY_DIR) / "golden-report";

bool renewing() {
  return std::getenv("MORPHKIT_RENEW_GOLDENS") != nullptr;
}

project::Project small(project::Project project) {
  const cv::Size size = *project.output.size;
  const double scale = static_cast<double>(kLongSide) / std::max(size.width, size.height);
  project.output.size = cv::Size(static_cast<int>(size.width * scale), static_cast<int>(size.height * scale));
  return project;
}

/// Painted once: painting takes longer than rendering.
const samples::Sample& painted(const std::string& name) {
  static std::map<std::string, samples::Sample> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second : known.emplace(name, samples::paint(name)).first->second;
}

void report(const std::string& name, const fs::path& actual, const warp::Image& expected, const warp::Image& rendered) {
  const auto write = [&](const std::string& what, const warp::Image& image) {
    media::WriteOptions options;
    options.overwrite = true;
    media::write_image(kReport / (name + "." + what + ".png"), image, options);
  };
  fs::copy_file(actual, kReport / (name + ".actual.png"), fs::copy_options::overwrite_existing);
  write("expected", expected);
  if (expected.size() == rendered.size()) write("difference", warp::difference_image(rendered, expected, 16));
}

class Golden : public testing::TestWithParam<std::tuple<std::string, double>> {};

TEST_P(Golden, LooksAsItDid) {
  const auto& [sample, t] = GetParam();
  const std::string name = fmt::format("{}-{:03.0f}", sample, t * 100);
  const test::TemporaryFolder folder;
  fs::create_directories(kReport);

  const project::Project project = small(project::load(samples::write(painted(sample), folder.path(), true)));
  const render::Renderer renderer(project, render::load_pictures(project));
  const fs::path actual_file = folder / (name + ".png");
  media::write_image(actual_file, renderer.frame(t));
  const warp::Image actual = media::read_picture(actual_file).image;

  const fs::path expected_file = kExpected / (name + ".png");
  if (renewing()) {
    const bool known = fs::exists(expected_file);
    const warp::Image before = known ? media::read_picture(expected_file).image : warp::Image();
    if (known && before.size() == actual.size() && warp::compare(actual, before).identical()) {
      std::cout << "unchanged " << name << "\n";
    } else {
      fs::copy_file(actual_file, expected_file, fs::copy_options::overwrite_existing);
      if (known && before.size() == actual.size()) {
        const warp::Difference difference = warp::compare(actual, before);
        std::cout << fmt::format("renewed   {}: {:.1f} dB, largest difference {:.1f}/255, {} pixels\n", name,
                                 difference.psnr_db, difference.max_abs * 255, difference.differing);
      } else {
        std::cout << "new       " << name << "\n";
      }
    }
  } else {
    ASSERT_TRUE(fs::exists(expected_file)) << "no expected picture; scripts/renew-goldens.sh makes it";
    const warp::Image expected = media::read_picture(expected_file).image;
    const bool same_size = expected.size() == actual.size();
    const warp::Difference difference = same_size ? warp::compare(actual, expected) : warp::Difference{};
    if (!same_size || !difference.within(kTolerance)) {
      report(name, actual_file, expected, actual);
      ADD_FAILURE() << fmt::format(
          "{}: {} against {}; {:.1f} dB, largest difference {:.1f}/255 at ({}, {}), {} pixels differ, {} not finite; "
          "see {}",
          name, fmt::format("{}x{}", actual.cols, actual.rows), fmt::format("{}x{}", expected.cols, expected.rows),
          difference.psnr_db, difference.max_abs * 255, difference.worst.x, difference.worst.y, difference.differing,
          difference.nonfinite, kReport.string());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Samples, Golden, testing::Combine(testing::ValuesIn(samples::names()), testing::Values(0.0, 0.25, 0.5, 0.75, 1.0)),
    [](const auto& parameter) {
      return fmt::format("{}_{:03.0f}", std::get<0>(parameter.param), std::get<1>(parameter.param) * 100);
    });

class SampleCheck : public testing::TestWithParam<std::string> {};

TEST_P(SampleCheck, HasNoFoldsAndNothingElseToComplainOf) {
  const test::TemporaryFolder folder;
  const project::Project project = project::load(samples::write(painted(GetParam()), folder.path(), true));
  const render::Renderer renderer(project, render::load_pictures(project));
  for (const render::Finding& finding : render::check(renderer)) ADD_FAILURE() << finding.message;
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleCheck, testing::ValuesIn(samples::names()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace morphkit
