#include "morph/render/placement.h"

#include <algorithm>

namespace morphkit::render {

Placement place(cv::Size image, cv::Size canvas, project::Fit fit) {
  const double sx = static_cast<double>(canvas.width) / image.width;
  const double sy = static_cast<double>(canvas.height) / image.height;
  Placement placement;
  switch (fit) {
    case project::Fit::kNone:
      break;
    case project::Fit::kContain:
      placement.scale = {std::min(sx, sy), std::min(sx, sy)};
      break;
    case project::Fit::kCover:
      placement.scale = {std::max(sx, sy), std::max(sx, sy)};
      break;
    case project::Fit::kStretch:
      placement.scale = {sx, sy};
      break;
  }
  placement.offset = {(canvas.width - image.width * placement.scale.x) / 2,
                      (canvas.height - image.height * placement.scale.y) / 2};
  return placement;
}

bool covers(const Placement& placement, cv::Size image, cv::Size canvas) {
  // A picture fitted to the canvas misses its edge only by rounding.
  constexpr double kSlackPx = 1e-6;
  const cv::Point2d first = placement.to_canvas({0, 0});
  const cv::Point2d last = placement.to_canvas({static_cast<double>(image.width), static_cast<double>(image.height)});
  return first.x <= kSlackPx && first.y <= kSlackPx && last.x >= canvas.width - kSlackPx &&
         last.y >= canvas.height - kSlackPx;
}

}  // namespace morphkit::render
