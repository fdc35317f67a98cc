#include "tests/golden/golden.h"

#include <cstdlib>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "warp/image/compare.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

const fs::path kExpected = fs::path(MORPHKIT_SOURCE_DIR) / "tests/golden/expected";
const fs::path kReport = fs::path(MORPHKIT_BINARY_DIR) / "golden-report";

bool renewing() {
  return std::getenv("MORPHKIT_RENEW_GOLDENS") != nullptr;
}

std::string size_text(const warp::Image& image) {
  return fmt::format("{}x{}", image.cols, image.rows);
}

void report(const std::string& name, const fs::path& actual_file, const warp::Image& expected,
            const warp::Image& actual) {
  fs::create_directories(kReport);
  const auto write = [&](const std::string& what, const warp::Image& image) {
    media::WriteOptions options;
    options.overwrite = true;
    media::write_image(kReport / (name + "." + what + ".png"), image, options);
  };
  fs::copy_file(actual_file, kReport / (name + ".actual.png"), fs::copy_options::overwrite_existing);
  write("expected", expected);
  if (expected.size() == actual.size()) write("difference", warp::difference_image(actual, expected, 16));
}

void renew(const std::string& name, const fs::path& expected_file, const fs::path& actual_file,
           const warp::Image& actual) {
  const bool known = fs::exists(expected_file);
  const warp::Image before = known ? media::read_picture(expected_file).image : warp::Image();
  const bool comparable = known && before.size() == actual.size();
  const warp::Difference difference = comparable ? warp::compare(actual, before) : warp::Difference{};
  if (comparable && difference.identical()) {
    std::cout << "unchanged " << name << "\n";
    return;
  }
  fs::copy_file(actual_file, expected_file, fs::copy_options::overwrite_existing);
  if (comparable) {
    std::cout << fmt::format("renewed   {}: {:.1f} dB, largest difference {:.1f}/255, {} pixels\n", name,
                             difference.psnr_db, difference.max_abs * 255, difference.differing);
  } else {
    std::cout << "new       " << name << "\n";
  }
}

}  // namespace

void expect_golden(const std::string& name, const fs::path& actual_file) {
  const warp::Image actual = media::read_picture(actual_file).image;
  const fs::path expected_file = kExpected / (name + ".png");
  if (renewing()) return renew(name, expected_file, actual_file, actual);
  ASSERT_TRUE(fs::exists(expected_file)) << "no expected picture; scripts/renew-goldens.sh makes it";
  const warp::Image expected = media::read_picture(expected_file).image;
  const bool same_size = expected.size() == actual.size();
  const warp::Difference difference = same_size ? warp::compare(actual, expected) : warp::Difference{};
  if (same_size && difference.within(kGoldenTolerance)) return;
  report(name, actual_file, expected, actual);
  ADD_FAILURE() << fmt::format(
      "{}: {} against {}; {:.1f} dB, largest difference {:.1f}/255 at ({}, {}), {} pixels differ, {} not finite; "
      "see {}",
      name, size_text(actual), size_text(expected), difference.psnr_db, difference.max_abs * 255, difference.worst.x,
      difference.worst.y, difference.differing, difference.nonfinite, kReport.string());
}

}  // namespace morphkit::test
