#pragma once
// Pictures with known values at every point, and the error of images made from them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/parallel.h"
#include "warp/image/image.h"

namespace morphkit::test {

/// The image of a picture, opaque grey; value(x, y) gives the grey of the pixel with its centre at (x, y).
template <typename Value>
warp::Image grey_image(cv::Size size, const Value& value) {
  warp::Image image(size);
  for_rows(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto grey = static_cast<float>(value(x + 0.5, y + 0.5));
        image(y, x) = {grey, grey, grey, 1.0F};
      }
    }
  });
  return image;
}

/// cos(phase) around the middle of a square, with a frequency that grows with the distance. A radial map reduces it: an
/// offset r from the output's middle, in units of 1024 px, shows the offset r (2 r^2 + 1) of the source. From 1:1 in
/// the middle to 4:1 along and 2:1 across at the corners of an output of 1024 px.
struct RadialPlate {
  double source_size, output_size;

  double value(cv::Point2d source) const {
    const cv::Point2d offset = source - cv::Point2d(source_size, source_size) / 2;
    return 0.5 + 0.5 * std::cos(std::numbers::pi * kChirp * offset.ddot(offset));
  }

  cv::Point2d radial(cv::Point2d output) const {
    const cv::Point2d offset = (output - cv::Point2d(output_size, output_size) / 2) / kUnit;
    return cv::Point2d(source_size, source_size) / 2 + kUnit * (2 * offset.ddot(offset) + 1) * offset;
  }

  /// Frequency of the plate in a correct output, cycles per pixel.
  double frequency(cv::Point2d output) const {
    const cv::Point2d offset = (output - cv::Point2d(output_size, output_size) / 2) / kUnit;
    const double square = offset.ddot(offset);
    return kChirp * kUnit * std::sqrt(square) * (2 * square + 1) * (6 * square + 1);
  }

 private:
  static constexpr double kUnit = 1024;
  static constexpr double kChirp = 0.4 / 1448.2;  // cycles per px, per px
};

/// A scene as a camera might see it: texture of waves that weaken with frequency, and edges of discs and a fence, as
/// sharp as a lens draws them. A pixel of its image is the mean over the pixel's square.
class Photograph {
 public:
  explicit Photograph(cv::Size size, unsigned seed = 2) : size_(size) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (Wave& wave : waves_) {
      const double frequency = std::exp(uniform(std::log(0.004), std::log(0.3)));
      const double angle = uniform(0, 2 * std::numbers::pi);
      wave.frequency = 2 * std::numbers::pi * frequency * cv::Point2d(std::cos(angle), std::sin(angle));
      wave.phase = uniform(0, 2 * std::numbers::pi);
      wave.height = 0.0016 / (frequency + 0.01);
    }
    const double unit = std::min(size.width, size.height);
    for (Disc& disc : discs_) {
      disc = {{uniform(0, size.width), uniform(0, size.height)}, unit * uniform(0.03, 0.2), uniform(-0.2, 0.2)};
    }
  }

  double value(cv::Point2d at) const {
    double grey = 0.5;
    for (const Wave& wave : waves_) grey += wave.height * std::sin(wave.frequency.ddot(at) + wave.phase);
    for (const Disc& disc : discs_) {
      const cv::Point2d offset = at - disc.middle;
      grey += disc.height * inside(disc.radius - std::sqrt(offset.ddot(offset)));
    }
    // A fence of slanted boards.
    const double across = std::remainder(at.x + 0.3 * at.y, 40);
    const double board = inside(at.y - 0.7 * size_.height) * inside(10 - std::abs(across));
    return std::lerp(grey, 0.85, board);
  }

  warp::Image image() const {
    // Gauss-Legendre: exact up to the fifth power in either direction.
    static constexpr std::array<double, 3> kAt{-0.3872983346207417, 0, 0.3872983346207417};
    static constexpr std::array<double, 3> kWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    return grey_image(size_, [&](double x, double y) {
      double mean = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3; ++i) mean += kWeight[i] * kWeight[j] * value({x + kAt[i], y + kAt[j]});
      }
      return mean;
    });
  }

 private:
  struct Wave {
    cv::Point2d frequency;  // radians per px
    double phase = 0, height = 0;
  };
  struct Disc {
    cv::Point2d middle;
    double radius = 0, height = 0;
  };

  /// The blur of a lens: an edge rises from 10 to 90 % within 1.4 px.
  static double inside(double distance_px) { return 0.5 + 0.5 * std::tanh(1.6 * distance_px); }

  cv::Size size_;
  std::array<Wave, 20> waves_;
  std::array<Disc, 9> discs_;
};

struct ReferencePixel {
  cv::Point at;
  double grey = 0;
};

/// PSNR in dB for values from 0 to 1, over the references that `counts` selects. NaN if there are none.
template <typename Grey, typename Counts>
double psnr(const std::vector<ReferencePixel>& references, const Grey& grey, const Counts& counts) {
  double sum = 0;
  double number = 0;
  for (const ReferencePixel& reference : references) {
    if (!counts(reference.at)) continue;
    const double error = grey(reference.at) - reference.grey;
    sum += error * error;
    number += 1;
  }
  return 10 * std::log10(number / sum);
}

/// Quality over the whole plate, over the part that should stay unchanged, and over the part that should vanish.
struct PlateQuality {
  double whole = 0, passband = 0, alias_zone = 0;
};

template <typename Grey>
PlateQuality plate_quality(const RadialPlate& plate, const std::vector<ReferencePixel>& references, const Grey& grey) {
  const auto frequency = [&](cv::Point at) { return plate.frequency(cv::Point2d(at) + cv::Point2d(0.5, 0.5)); };
  return {psnr(references, grey, [](cv::Point) { return true; }),
          psnr(references, grey, [&](cv::Point at) { return frequency(at) < 0.25; }),
          psnr(references, grey, [&](cv::Point at) { return frequency(at) > 0.7; })};
}

}  // namespace morphkit::test
