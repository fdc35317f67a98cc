#pragma once
// A picture at every size that a view may need.

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "warp/image/image.h"

namespace morphkit::edit {

/// Level 0 is the picture; each further level has half the size, rounded up, by area averaging. The last one is at most
/// kSmallestLevel px wide and high. Cost: a third of the picture in memory, and four bytes for every pixel of it.
class Pyramid {
 public:
  /// @param picture  shared, not copied.
  explicit Pyramid(const warp::Image& picture);

  cv::Size size() const noexcept { return levels_.front().size(); }

  /// The smallest level that need not be magnified to show the picture at `scale` px per pixel; level 0 if all must be.
  std::size_t level(double scale) const noexcept;

  /// Linear, premultiplied.
  const warp::Image& light(double scale) const noexcept { return levels_[level(scale)]; }
  /// The same for the screen. From one thread at a time: the largest level, which is seldom looked at, is made when it
  /// is first asked for.
  const cv::Mat3b& display(double scale) const;

 private:
  std::vector<warp::Image> levels_;
  mutable std::vector<cv::Mat3b> shown_;
};

inline constexpr int kSmallestLevel = 256;

}  // namespace morphkit::edit
