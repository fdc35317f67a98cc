#include "cli/edit/view/view.h"

#include <algorithm>

namespace morphkit::edit {
namespace {

/// Margin of the pane on each side, px.
constexpr double kMarginPx = 8;

double kept(double zoom) {
  return std::clamp(zoom, kMinZoom, kMaxZoom);
}

/// The length of an axis of the pane without margins; a pane too small for margins keeps half.
double inside(int pane) {
  return std::max(pane - 2 * kMarginPx, pane / 2.0);
}

}  // namespace

View fitted(cv::Size picture, cv::Size pane) {
  View view;
  view.zoom = kept(std::min(inside(pane.width) / picture.width, inside(pane.height) / picture.height));
  view.centre = {picture.width / 2.0, picture.height / 2.0};
  return view;
}

View zoomed(const View& view, double factor, cv::Point2d in_pane, cv::Size pane) {
  const double zoom = kept(view.zoom * factor);
  if (zoom == view.zoom) return view;
  const cv::Point2d stays = view.to_picture(in_pane, pane);
  const cv::Point2d from_middle = in_pane - cv::Point2d(pane.width / 2.0, pane.height / 2.0);
  return {zoom, stays - from_middle / zoom};
}

View matching(const View& view, cv::Size picture, cv::Size other) {
  const double across = static_cast<double>(other.width) / picture.width;
  const double down = static_cast<double>(other.height) / picture.height;
  return {kept(view.zoom / across), {view.centre.x * across, view.centre.y * down}};
}

}  // namespace morphkit::edit
