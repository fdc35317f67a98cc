#pragma once
// A picture at several sizes, for any zoom.

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "warp/image/image.h"

namespace morphkit::edit {

/// Level 0 is the picture; each further level has half the size, rounded up, by area averaging. The last level is at
/// most kSmallestLevel px wide and high. Cost: memory for a third of the picture, and four bytes per pixel.
class Pyramid {
 public:
  /// @param picture  shared, not copied.
  explicit Pyramid(const warp::Image& picture);

  cv::Size size() const noexcept { return levels_.front().size(); }

  /// The smallest level that is not magnified at `scale` screen px per picture px; level 0 if every level is.
  std::size_t level(double scale) const noexcept;

  /// Linear, premultiplied.
  const warp::Image& light(double scale) const noexcept { return levels_[level(scale)]; }
  /// The same as screen colours, BGR. Not thread-safe: level 0, which is seldom needed, is made on first use.
  const cv::Mat3b& display(double scale) const;

 private:
  std::vector<warp::Image> levels_;
  mutable std::vector<cv::Mat3b> shown_;
};

inline constexpr int kSmallestLevel = 256;

}  // namespace morphkit::edit
