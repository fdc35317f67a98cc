#include "cli/edit/view/panes.h"

#include <algorithm>
#include <cmath>

namespace morphkit::edit {
namespace {

// In units of the scale.
constexpr double kTop = 46, kHead = 32, kTime = 44, kTuning = 46, kStatus = 30, kMargin = 8;

double scale_of(cv::Size canvas) {
  return std::clamp(std::min(canvas.width / 1600.0, canvas.height / 900.0), 0.72, 2.0);
}

}  // namespace

Panes panes_of(cv::Size canvas) {
  Panes result;
  result.scale = scale_of(canvas);
  const auto px = [&](double units) { return static_cast<int>(std::lround(units * result.scale)); };
  result.top = {0, 0, canvas.width, px(kTop)};
  result.status = {0, canvas.height - px(kStatus), canvas.width, px(kStatus)};
  result.tuning = {0, result.status.y - px(kTuning), canvas.width, px(kTuning)};
  result.time = {0, result.tuning.y - px(kTime), canvas.width, px(kTime)};
  const int head = result.top.br().y;
  const int top = head + px(kHead);
  const int margin = px(kMargin);
  const int width = (canvas.width - 4 * margin) / 3;
  for (int i = 0; i < 3; ++i) {
    const int x = margin + i * (width + margin);
    result.heads[i] = {x, head, width, px(kHead)};
    result.panes[i] = {x, top, width, result.time.y - top};
  }
  return result;
}

std::optional<Pane> Panes::pane_at(cv::Point position) const {
  for (const Pane candidate : kPanes)
    if (pane(candidate).contains(position)) return candidate;
  return std::nullopt;
}

}  // namespace morphkit::edit
