#pragma once
// Helpers of the image tests: a temporary folder, random pictures, bytes of files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {

/// Linear, premultiplied noise in [0, 1].
inline warp::Image random_image(int width, int height, bool with_alpha, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  warp::Image image(height, width);
  for (warp::Pixel& pixel : image) {
    const float alpha = with_alpha ? unit(random) : 1.0F;
    pixel = warp::Pixel(unit(random) * alpha, unit(random) * alpha, unit(random) * alpha, alpha);
  }
  return image;
}

/// Largest difference of a sample; NaN counts as infinite.
inline double distance(const warp::Image& a, const warp::Image& b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 0;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      for (int c = 0; c < 4; ++c) {
        const double difference = std::abs(double{a(y, x)[c]} - double{b(y, x)[c]});
        if (!(difference <= largest)) largest = std::isnan(difference) ? INFINITY : difference;
      }
    }
  }
  return largest;
}

}  // namespace morphkit::test
