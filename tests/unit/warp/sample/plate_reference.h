#pragma once
// The zone plate of 2048 x 2048 px reduced to 1024 x 1024 by a radial map, and the correct result: picture and map have
// known values at every point. For the quality test and the benchmark of sampling.

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/known_pictures.h"

namespace morphkit::test {

class PlateReduction {
 public:
  static constexpr int kSourceSize = 2048;
  static constexpr int kOutputSize = 1024;
  static constexpr int kLeftOut = 8;  // px at the border

  static constexpr RadialPlate plate() { return {kSourceSize, kOutputSize}; }

  static warp::Image source() {
    return grey_image({kSourceSize, kSourceSize}, [](double x, double y) { return plate().value({x, y}); });
  }

  static warp::Map map() {
    warp::Map map(kOutputSize, kOutputSize);
    for (int y = 0; y < kOutputSize; ++y) {
      for (int x = 0; x < kOutputSize; ++x) {
        const cv::Point2d source = plate().radial({x + 0.5, y + 0.5});
        map(y, x) = {static_cast<float>(source.x), static_cast<float>(source.y)};
      }
    }
    return map;
  }

  /// The mean of 16 x 16 samples over the pixel, of every `stride`-th pixel of every `stride`-th row.
  static std::vector<ReferencePixel> box_references(int stride) {
    return references(stride, 16, 0.5, [](double) { return 1.0; });
  }

  /// Lanczos-3 by 8 x 8 samples per pixel.
  static std::vector<ReferencePixel> lanczos_references(int stride) {
    return references(stride, 8, 3, [](double u) {
      const double angle = std::numbers::pi * u;
      return u == 0 ? 1.0 : 3 * std::sin(angle) * std::sin(angle / 3) / (angle * angle);
    });
  }

 private:
  /// A normalised, separable kernel with a radius of `radius` output px.
  template <typename Kernel>
  static std::vector<ReferencePixel> references(int stride, int samples_per_pixel, double radius,
                                                const Kernel& kernel) {
    const int samples = static_cast<int>(2 * radius * samples_per_pixel);
    std::vector<double> offsets;
    std::vector<double> weights;
    offsets.reserve(static_cast<std::size_t>(samples));
    weights.reserve(static_cast<std::size_t>(samples));
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
      offsets.push_back((i + 0.5) / samples_per_pixel - radius);
      weights.push_back(kernel(offsets.back()));
      sum += weights.back();
    }
    std::vector<ReferencePixel> pixels;
    for (int y = kLeftOut; y < kOutputSize - kLeftOut; y += stride) {
      for (int x = kLeftOut; x < kOutputSize - kLeftOut; x += stride) pixels.push_back({{x, y}, 0});
    }
    for_rows(static_cast<int>(pixels.size()), [&](int begin, int end) {
      for (int k = begin; k < end; ++k) {
        ReferencePixel& pixel = pixels[static_cast<std::size_t>(k)];
        const cv::Point2d centre = cv::Point2d(pixel.at) + cv::Point2d(0.5, 0.5);
        for (std::size_t j = 0; j < weights.size(); ++j) {
          for (std::size_t i = 0; i < weights.size(); ++i) {
            const cv::Point2d at = centre + cv::Point2d(offsets[i], offsets[j]);
            pixel.grey += weights[i] * weights[j] / (sum * sum) * plate().value(plate().radial(at));
          }
        }
      }
    });
    return pixels;
  }
};

}  // namespace morphkit::test
