#pragma once
// Pictures for commands, and what a person who gets them wrong is told.

#include <string>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "warp/image/color.h"

namespace morphkit::test {

inline warp::Image gradient(cv::Size size) {
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float r = warp::linear_from_srgb(static_cast<float>((x * 7) % 256) / 255);
      const float g = warp::linear_from_srgb(static_cast<float>((y * 5) % 256) / 255);
      image(y, x) = {r, g, 0.5F * (r + g), 1};
    }
  }
  return image;
}

/// A PNG of 40x30 and its text name.
inline std::string write_gradient(const TemporaryFolder& folder, const std::string& name, cv::Size size = {40, 30}) {
  media::write_image(folder / name, gradient(size));
  return (folder / name).string();
}

/// The gradient with the red of pixel (11, 7) changed by one step of 8 bits.
inline std::string write_changed(const TemporaryFolder& folder, const std::string& name) {
  warp::Image image = gradient({40, 30});
  image(7, 11)[0] = warp::linear_from_srgb(78.0F / 255);
  media::write_image(folder / name, image);
  return (folder / name).string();
}

inline void expect_usage_error(const RunResult& result, const std::string& message) {
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_TRUE(contains(result.err, message)) << result.err;
  EXPECT_EQ(result.out, "");
}

}  // namespace morphkit::test
