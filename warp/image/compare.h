#pragma once
// How far apart two images are, and where. Shared by `morphkit compare` and the golden tests.

#include <cstdint>

#include "warp/image/image.h"

namespace morphkit::warp {

/// The result of `compare`. Values are on the scale that `comparison_value` defines: 1 is the step from black to white,
/// 1/255 one step of an 8-bit file.
struct Difference {
  double psnr_db = 0;          ///< -10 log10 of the mean squared difference; +inf if equal, -inf if any is not finite
  double max_abs = 0;          ///< largest difference of a channel; +inf if any is not finite
  cv::Point worst{-1, -1};     ///< the first pixel, in rows, that has max_abs; (-1, -1) if all are equal
  std::int64_t differing = 0;  ///< pixels with any channel unequal, or not finite in either image
  std::int64_t nonfinite = 0;  ///< pixels with NaN or an infinity in either image, even if both have the same

  /// Every channel of every pixel is equal and finite. (Zeros of either sign are equal.)
  bool identical() const noexcept { return differing == 0; }

  /// No channel differs by more than `tolerance` and all is finite; a tolerance of 0 means `identical`. That is
  /// stricter than max_abs == 0: linear values may differ by less than the comparison scale resolves.
  bool within(double tolerance) const noexcept {
    return identical() || (tolerance > 0 && nonfinite == 0 && max_abs <= tolerance);
  }
};

/// A linear, premultiplied pixel on the scale of comparisons: colour channels through the sRGB curve, alpha as it is.
/// Premultiplied, so that the colour of transparent pixels does not count.
Pixel comparison_value(const Pixel& pixel) noexcept;

/// Compares two images pixel by pixel over all four channels.
/// @param a, b  linear, premultiplied RGBA of equal size.
/// @throws std::invalid_argument if the sizes differ.
/// Values that are not finite always count as a difference. The same result for any number of threads.
/// Cost: O(pixels); two calls of pow per unequal channel.
Difference compare(const Image& a, const Image& b);

/// A picture of |a - b| on the comparison scale, times `gain`, opaque: each colour channel shows the larger of its own
/// difference and alpha's. Pixels that are not finite in either are magenta.
/// @param gain  >= 0.
/// @return      linear, so that a file written from it shows `gain` times the difference; size of a.
/// @throws std::invalid_argument if the sizes differ.
Image difference_image(const Image& a, const Image& b, double gain);

}  // namespace morphkit::warp
