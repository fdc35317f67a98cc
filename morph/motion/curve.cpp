#include "morph/motion/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace morphkit::motion {
namespace {

using Points = std::vector<cv::Point2d>;

// Far beyond any image. Keeps sums and products of coordinates accurate enough to be useful.
constexpr double kLargestCoordinate = 1e12;

double length(cv::Point2d v) {
  return std::hypot(v.x, v.y);
}

Points polyline_pieces(const Points& points, std::size_t segments) {
  Points bezier;
  for (std::size_t i = 0; i < segments; ++i) {
    const cv::Point2d a = points[i], b = points[(i + 1) % points.size()];
    bezier.insert(bezier.end(), {a, a + (b - a) / 3, b - (b - a) / 3});
  }
  return bezier;
}

// A Catmull-Rom tangent is shared by a short and a long neighbour. Scaling by 2 l / (l + l_neighbour) gives each
// segment a tangent of its own size, so the curve does not double back beside a long segment (Gascuel & Lyon 1995, eq.
// 3). `own` is the length of the tangent's segment.
cv::Point2d tangent(cv::Point2d chord_before, cv::Point2d chord_after, double own) {
  const double sum = length(chord_before) + length(chord_after);
  return sum > 0 ? (chord_before + chord_after) * (own / sum) : cv::Point2d{};
}

Points catmull_rom_pieces(const Points& points, std::size_t segments, bool closed) {
  const std::size_t n = points.size();
  // chords[i + 1] leads from point i to the next; the outermost two reflect their neighbours (P_-1 = 2 P_0 - P_1).
  Points chords(segments + 2);
  for (std::size_t i = 0; i < segments; ++i) chords[i + 1] = points[(i + 1) % n] - points[i];
  chords.front() = closed ? chords[segments] : chords[1];
  chords.back() = closed ? chords[1] : chords[segments];

  Points bezier;
  for (std::size_t i = 0; i < segments; ++i) {
    const cv::Point2d begin = points[i], end = points[(i + 1) % n];
    const double own = length(chords[i + 1]);
    const cv::Point2d outgoing = tangent(chords[i], chords[i + 1], own);
    const cv::Point2d incoming = tangent(chords[i + 1], chords[i + 2], own);
    bezier.insert(bezier.end(), {begin, begin + outgoing / 3, end - incoming / 3});
  }
  return bezier;
}

std::size_t smallest_count(CurveKind kind, bool closed) {
  if (kind == CurveKind::kBezier) return closed ? 3 : 4;
  return closed ? 3 : 2;
}

std::optional<std::string> count_problem(CurveKind kind, std::size_t count, bool closed) {
  const std::size_t smallest = smallest_count(kind, closed);
  const bool wrong_number = kind == CurveKind::kBezier && count % 3 != (closed ? 0 : 1);
  if (count >= smallest && !wrong_number) return std::nullopt;
  const std::string which = closed ? "a closed " : "an open ";
  const std::string rule = kind != CurveKind::kBezier ? "curve needs at least " + std::to_string(smallest) + " points"
                           : closed                   ? "Bezier curve needs 3n points (3, 6, 9, ...)"
                                                      : "Bezier curve needs 3n + 1 points (4, 7, 10, ...)";
  return which + rule + ", but has " + std::to_string(count);
}

}  // namespace

std::optional<std::string> Curve::problem(CurveKind kind, const Points& points, bool closed) {
  if (auto count = count_problem(kind, points.size(), closed)) return count;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double largest = std::max(std::abs(points[i].x), std::abs(points[i].y));
    const std::string where = "point " + std::to_string(i) + " of the curve ";
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) return where + "must have two finite coordinates";
    if (largest > kLargestCoordinate) return where + "must lie within 1e12 of the origin";
  }
  const auto same = [&](cv::Point2d p) { return p == points.front(); };
  if (std::ranges::all_of(points, same)) return "all points of the curve coincide; at least two must differ";
  return std::nullopt;
}

Curve::Curve(CurveKind kind, Points points, bool closed) : closed_(closed) {
  if (const auto reason = problem(kind, points, closed)) throw std::invalid_argument(*reason);
  const cv::Point2d end = closed ? points.front() : points.back();
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  switch (kind) {
    case CurveKind::kPolyline:
      bezier_ = polyline_pieces(points, segments);
      break;
    case CurveKind::kCatmullRom:
      bezier_ = catmull_rom_pieces(points, segments, closed);
      break;
    case CurveKind::kBezier:
      bezier_ = std::move(points);
      if (!closed) bezier_.pop_back();
      break;
  }
  bezier_.push_back(end);
}

namespace {

struct Place {
  std::size_t first;  // control point where the segment begins
  double t;           // within the segment, [0, 1]
};

Place place(double u, int segments) {
  const double inside = u > 0 ? std::min(u, static_cast<double>(segments)) : 0;
  const int segment = std::min(static_cast<int>(inside), segments - 1);
  return {static_cast<std::size_t>(segment) * 3, inside - segment};
}

}  // namespace

cv::Point2d Curve::at(double u) const {
  const auto [i, t] = place(u, segments());
  const double v = 1 - t;
  return bezier_[i] * (v * v * v) + bezier_[i + 1] * (3 * v * v * t) + bezier_[i + 2] * (3 * v * t * t) +
         bezier_[i + 3] * (t * t * t);
}

cv::Point2d Curve::derivative(double u) const {
  const auto [i, t] = place(u, segments());
  const double v = 1 - t;
  return (bezier_[i + 1] - bezier_[i]) * (3 * v * v) + (bezier_[i + 2] - bezier_[i + 1]) * (6 * v * t) +
         (bezier_[i + 3] - bezier_[i + 2]) * (3 * t * t);
}

}  // namespace morphkit::motion
