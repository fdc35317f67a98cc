#include "cli/edit/hand/snap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/edit/document/marks.h"

namespace morphkit::edit {
namespace {

/// Least gradient of an edge: code values per px, and times the median around it.
constexpr double kMinGradient = 14;
constexpr double kOutstanding = 2;
constexpr double kMinWindow = 6;  ///< half size of the window of the median, px

/// Green stands for brightness: it has the largest share and needs no sum.
double brightness(const cv::Mat3b& picture, int x, int y) {
  return picture(std::clamp(y, 0, picture.rows - 1), std::clamp(x, 0, picture.cols - 1))[1];
}

/// By central differences over two px, smoothed across.
cv::Point2d gradient(const cv::Mat3b& picture, int x, int y) {
  cv::Point2d sum;
  for (int i = -1; i <= 1; ++i) {
    const double weight = i == 0 ? 0.25 : 0.125;
    sum.x += weight * (brightness(picture, x + 1, y + i) - brightness(picture, x - 1, y + i));
    sum.y += weight * (brightness(picture, x + i, y + 1) - brightness(picture, x + i, y - 1));
  }
  return sum;
}

double strength(const cv::Mat3b& picture, int x, int y) {
  const cv::Point2d g = gradient(picture, x, y);
  return std::hypot(g.x, g.y);
}

/// Offset of the maximum of the parabola through three values, px.
double top_of_parabola(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

cv::Point2d refined(const cv::Mat3b& picture, cv::Point at) {
  const cv::Point2d g = gradient(picture, at.x, at.y);
  const double here = std::hypot(g.x, g.y);
  cv::Point2d result(at.x + 0.5, at.y + 0.5);
  if (std::abs(g.x) >= std::abs(g.y)) {
    result.x += top_of_parabola(strength(picture, at.x - 1, at.y), here, strength(picture, at.x + 1, at.y));
  } else {
    result.y += top_of_parabola(strength(picture, at.x, at.y - 1), here, strength(picture, at.x, at.y + 1));
  }
  return result;
}

/// Pixels of the picture within `reach` of a position.
cv::Rect around(cv::Point2d centre, double reach, cv::Size size) {
  const cv::Point first(static_cast<int>(std::floor(centre.x - reach)), static_cast<int>(std::floor(centre.y - reach)));
  const cv::Point last(static_cast<int>(std::ceil(centre.x + reach)), static_cast<int>(std::ceil(centre.y + reach)));
  return cv::Rect(first, last) & cv::Rect({0, 0}, size);
}

/// The median.
double median_strength(const cv::Mat3b& picture, const cv::Rect& window) {
  std::vector<double> strengths;
  strengths.reserve(static_cast<std::size_t>(window.area()));
  for (int y = window.y; y < window.br().y; ++y)
    for (int x = window.x; x < window.br().x; ++x) strengths.push_back(strength(picture, x, y));
  const auto middle = strengths.begin() + static_cast<std::ptrdiff_t>(strengths.size() / 2);
  std::nth_element(strengths.begin(), middle, strengths.end());
  return *middle;
}

}  // namespace

std::optional<cv::Point2d> strongest_edge(const Pyramid& picture, cv::Point2d position, double radius, double zoom) {
  const cv::Mat3b& level = picture.display(zoom);
  // Per axis, because level sizes are rounded.
  const cv::Point2d shrink(static_cast<double>(level.cols) / picture.size().width,
                           static_cast<double>(level.rows) / picture.size().height);
  const cv::Point2d centre(position.x * shrink.x, position.y * shrink.y);
  const double reach = radius * std::min(shrink.x, shrink.y);
  // When magnified the reach is a fraction of a pixel, so the median needs a larger window.
  const cv::Rect window = around(centre, std::max(reach, kMinWindow), level.size());
  if (window.empty()) return std::nullopt;
  const double least = std::max(kMinGradient, kOutstanding * median_strength(level, window));

  std::optional<cv::Point2d> found;
  double best = 0;
  for (int y = window.y; y < window.br().y; ++y)
    for (int x = window.x; x < window.br().x; ++x) {
      const double here = strength(level, x, y);
      if (here < least) continue;
      const cv::Point2d at = refined(level, {x, y});
      const double distance = std::hypot(at.x - centre.x, at.y - centre.y);
      // Prefer near edges.
      const double likely = here * (1 - 0.5 * distance / reach);
      if (distance > reach || likely <= best) continue;
      best = likely;
      found = cv::Point2d(at.x / shrink.x, at.y / shrink.y);
    }
  return found;
}

cv::Point2d rounded(cv::Point2d position, double zoom) {
  const double steps = std::pow(10.0, std::ceil(std::log10(10 * zoom)));  // per px: tenths of a screen px or finer
  return {std::round(position.x * steps) / steps, std::round(position.y * steps) / steps};
}

std::optional<cv::Point2d> nearest_end(const Document& document, SideIndex side, cv::Point2d position, double radius,
                                       int except) {
  std::optional<cv::Point2d> nearest;
  double least = radius;
  const auto& features = document.project().features;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (static_cast<int>(i) == except) continue;
    for (const cv::Point2d& point : points_of(features[i], side)) {
      const double distance = std::hypot(point.x - position.x, point.y - position.y);
      if (distance > least) continue;
      least = distance;
      nearest = point;
    }
  }
  return nearest;
}

}  // namespace morphkit::edit
