#include "cli/edit/view/pyramid.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "cli/edit/view/screen.h"

namespace morphkit::edit {

Pyramid::Pyramid(const warp::Image& picture) : levels_{picture} {
  while (std::max(levels_.back().cols, levels_.back().rows) > kSmallestLevel) {
    const warp::Image& larger = levels_.back();
    warp::Image smaller;
    cv::resize(larger, smaller, {(larger.cols + 1) / 2, (larger.rows + 1) / 2}, 0, 0, cv::INTER_AREA);
    levels_.push_back(smaller);
  }
  shown_.resize(levels_.size());
  for (std::size_t i = 1; i < levels_.size(); ++i) shown_[i] = to_screen(levels_[i]);
}

const cv::Mat3b& Pyramid::display(double scale) const {
  const std::size_t wanted = level(scale);
  if (shown_[wanted].empty()) shown_[wanted] = to_screen(levels_[wanted]);
  return shown_[wanted];
}

std::size_t Pyramid::level(double scale) const noexcept {
  std::size_t best = 0;
  while (best + 1 < levels_.size() && levels_[best + 1].cols >= size().width * scale &&
         levels_[best + 1].rows >= size().height * scale)
    ++best;
  return best;
}

}  // namespace morphkit::edit
