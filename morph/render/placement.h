#pragma once
// The placement of a picture on the canvas, and interpolation between positions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"

namespace morphkit::render {

/// std::lerp gives both ends exactly, and does not move if they are equal; (1 - s) a + s b does neither.
inline cv::Point2d lerp(cv::Point2d a, cv::Point2d b, double s) {
  return {std::lerp(a.x, b.x, s), std::lerp(a.y, b.y, s)};
}

inline double lerp(double a, double b, double s) {
  return std::lerp(a, b, s);
}

/// The mean of value_of(side) over the pictures; the weights sum to 1. It is exact where all values are equal, and
/// where one picture has all the weight.
template <typename ValueOf>
auto mean(std::span<const double> weights, const ValueOf& value_of) {
  if (weights.size() == 2) return lerp(value_of(0), value_of(1), weights[1]);
  const auto heaviest = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
  auto result = value_of(heaviest);
  for (std::size_t side = 0; side < weights.size(); ++side)
    if (side != heaviest) result += weights[side] * (value_of(side) - value_of(heaviest));
  return result;
}

/// canvas = image * scale + offset, per axis.
struct Placement {
  cv::Point2d scale{1, 1};
  cv::Point2d offset{0, 0};

  cv::Point2d to_canvas(cv::Point2d image) const {
    return {image.x * scale.x + offset.x, image.y * scale.y + offset.y};
  }
  cv::Point2d to_image(cv::Point2d canvas) const {
    return {(canvas.x - offset.x) / scale.x, (canvas.y - offset.y) / scale.y};
  }
  bool is_identity() const { return scale == cv::Point2d{1, 1} && offset == cv::Point2d{0, 0}; }
};

/// Places an image centred on the canvas. kNone keeps its size, kContain shows all of it, kCover fills the canvas,
/// kStretch changes its aspect. The identity if the sizes are equal.
Placement place(cv::Size image, cv::Size canvas, project::Fit fit);

/// Whether the placed image covers the canvas.
bool covers(const Placement& placement, cv::Size image, cv::Size canvas);

}  // namespace morphkit::render
