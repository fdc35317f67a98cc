#include "cli/edit/view/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace morphkit::edit {
namespace {

constexpr int kShift = 4;         ///< bits of a fraction of a px
constexpr double kBeyond = 2000;  ///< px around the picture in which drawing is left to OpenCV

cv::Point fixed(cv::Point2d at) {
  constexpr double kUnit = 1 << kShift;
  // Pixel centres lie at halves here and at whole numbers there.
  return {static_cast<int>(std::lround((at.x - 0.5) * kUnit)), static_cast<int>(std::lround((at.y - 0.5) * kUnit))};
}

cv::Scalar scalar(const cv::Vec3b& color) {
  return {static_cast<double>(color[0]), static_cast<double>(color[1]), static_cast<double>(color[2])};
}

/// Cuts a segment to the rectangle. @return false if nothing is left. Liang and Barsky 1984.
bool clip(cv::Point2d& p, cv::Point2d& q, const cv::Rect2d& to) {
  const cv::Point2d d = q - p;
  double begin = 0;
  double end = 1;
  const std::array<std::pair<double, double>, 4> edges{
      {{-d.x, p.x - to.x}, {d.x, to.br().x - p.x}, {-d.y, p.y - to.y}, {d.y, to.br().y - p.y}}};
  for (const auto& [slope, room] : edges) {
    if (slope == 0) {
      if (room < 0) return false;
      continue;
    }
    const double u = room / slope;
    if (slope < 0) {
      begin = std::max(begin, u);
    } else {
      end = std::min(end, u);
    }
  }
  if (!(begin <= end)) return false;
  const cv::Point2d start = p;
  p = start + begin * d;
  q = start + end * d;
  return true;
}

bool far_from(const cv::Mat3b& picture, cv::Point2d at) {
  return !(at.x > -kBeyond && at.y > -kBeyond && at.x < picture.cols + kBeyond && at.y < picture.rows + kBeyond);
}

}  // namespace

cv::Vec3b feature_color(int feature) {
  constexpr double kGoldenAngle = 137.50776405;
  const double hue = std::fmod(35 + kGoldenAngle * feature, 360.0) / 2;
  const cv::Mat3b hsv(1, 1, cv::Vec3b(cv::saturate_cast<uchar>(hue), 150, 245));
  cv::Mat3b bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  return bgr(0, 0);
}

cv::Vec3b mixed(const cv::Vec3b& a, const cv::Vec3b& b, double share) {
  cv::Vec3b result;
  for (int c = 0; c < 3; ++c) result[c] = cv::saturate_cast<uchar>(a[c] + share * (b[c] - a[c]));
  return result;
}

void fill(cv::Mat3b& picture, const cv::Rect& rect, const cv::Vec3b& color, int radius, double cover) {
  const cv::Rect inside = rect & cv::Rect({0, 0}, picture.size());
  if (inside.empty()) return;
  cv::Mat3b target = picture(inside);
  if (radius <= 0) {
    if (cover >= 1) {
      target.setTo(scalar(color));
    } else {
      cv::addWeighted(target, 1 - cover, cv::Mat3b(target.size(), color), cover, 0, target);
    }
    return;
  }
  cv::Mat1b mask(rect.size(), uchar{0});
  const int r = std::min({radius, rect.width / 2, rect.height / 2});
  const cv::Scalar on = cv::Scalar::all(std::round(255 * cover));
  cv::rectangle(mask, {r, 0}, {rect.width - 1 - r, rect.height - 1}, on, cv::FILLED);
  cv::rectangle(mask, {0, r}, {rect.width - 1, rect.height - 1 - r}, on, cv::FILLED);
  for (const cv::Point corner : {cv::Point(r, r), cv::Point(rect.width - 1 - r, r), cv::Point(r, rect.height - 1 - r),
                                 cv::Point(rect.width - 1 - r, rect.height - 1 - r)})
    cv::circle(mask, corner, r, on, cv::FILLED, cv::LINE_AA);
  const cv::Point shift = inside.tl() - rect.tl();
  for (int y = 0; y < target.rows; ++y)
    for (int x = 0; x < target.cols; ++x) {
      const int weight = mask(y + shift.y, x + shift.x);
      cv::Vec3b& pixel = target(y, x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<uchar>((pixel[c] * (255 - weight) + color[c] * weight + 127) / 255);
    }
}

void stroke(cv::Mat3b& picture, const std::vector<cv::Point2d>& points, const cv::Vec3b& color, int thickness) {
  const cv::Rect2d around(-kBeyond, -kBeyond, picture.cols + 2 * kBeyond, picture.rows + 2 * kBeyond);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    cv::Point2d p = points[i];
    cv::Point2d q = points[i + 1];
    if (clip(p, q, around)) cv::line(picture, fixed(p), fixed(q), scalar(color), thickness, cv::LINE_AA, kShift);
  }
}

void disc(cv::Mat3b& picture, cv::Point2d centre, double radius, const cv::Vec3b& color) {
  if (far_from(picture, centre)) return;
  cv::circle(picture, fixed(centre), static_cast<int>(std::lround(radius * (1 << kShift))), scalar(color), cv::FILLED,
             cv::LINE_AA, kShift);
}

void ring(cv::Mat3b& picture, cv::Point2d centre, double radius, const cv::Vec3b& color, int thickness) {
  if (far_from(picture, centre)) return;
  cv::circle(picture, fixed(centre), static_cast<int>(std::lround(radius * (1 << kShift))), scalar(color), thickness,
             cv::LINE_AA, kShift);
}

void polygon(cv::Mat3b& picture, const std::vector<cv::Point2d>& corners, const cv::Vec3b& color) {
  std::vector<cv::Point> fixed_corners;
  for (const cv::Point2d& corner : corners) {
    if (far_from(picture, corner)) return;
    fixed_corners.push_back(fixed(corner));
  }
  cv::fillConvexPoly(picture, fixed_corners, scalar(color), cv::LINE_AA, kShift);
}

cv::Mat3b placed(const cv::Mat3b& picture, const cv::Matx23d& map, cv::Size size, int how) {
  const cv::Scalar behind(palette::kBackground[0], palette::kBackground[1], palette::kBackground[2]);
  // Only the visible part, because OpenCV does not support 32767 px or more here.
  const auto held = [](double at, int most) { return static_cast<int>(std::clamp(at, 0.0, 1.0 * most)); };
  const double right = map(0, 2) + map(0, 0) * size.width, bottom = map(1, 2) + map(1, 1) * size.height;
  const cv::Point first(held(std::floor(map(0, 2)) - 1, picture.cols), held(std::floor(map(1, 2)) - 1, picture.rows));
  const cv::Point last(held(std::ceil(right) + 2, picture.cols), held(std::ceil(bottom) + 2, picture.rows));
  const cv::Rect seen(first, last);
  if (seen.empty()) return {size, palette::kBackground};
  cv::Matx23d from_seen = map;
  from_seen(0, 2) -= seen.x;
  from_seen(1, 2) -= seen.y;
  cv::Mat3b result;
  cv::warpAffine(picture(seen), result, from_seen, size, how | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, behind);
  return result;
}

}  // namespace morphkit::edit
