#include "cli/edit/document/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>

#include "base/error.h"
#include "morph/json/json.h"
#include "morph/project/limits.h"

namespace morphkit::edit {
namespace {

using project::Feature;
using project::kMaxCoordinate;
using project::Mark;
using project::SideIndex;

bool within_limits(const Points& points) {
  return std::ranges::all_of(points, [](cv::Point2d p) { return finite(p) && p == clamped(p); });
}

bool ends_meet(const Points& points) {
  return points.front() == points.back();
}

/// Whether the points are a mark of this kind on one side.
bool fits(const Mark& mark, const Points& points) {
  if (std::holds_alternative<project::Point>(mark)) return points.size() == 1;
  if (std::holds_alternative<project::Line>(mark)) return points.size() == 2;
  const auto& curve = std::get<project::Curve>(mark);
  return points.size() <= project::kMaxPoints && !motion::Curve::problem(curve.kind, points, curve.closed);
}

/// Whether both ends of an open feature lie at the same place, on both sides.
bool is_joined(const Feature& feature) {
  return !std::holds_alternative<project::Point>(feature.mark) && !is_closed(feature.mark) &&
         ends_meet(feature.places[project::kSource]);
}

/// The nearest value to `by` that keeps `least` and `most` within the limits.
double limited(double by, double least, double most) {
  return std::clamp(by, std::min(0.0, -kMaxCoordinate - least), std::max(0.0, kMaxCoordinate - most));
}

}  // namespace

Points& points_of(Feature& feature, SideIndex side) {
  return feature.places[side];
}

const Points& points_of(const Feature& feature, SideIndex side) {
  return feature.places[side];
}

bool finite(cv::Point2d point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

cv::Point2d rounded_off(cv::Point2d point) {
  constexpr double kSteps = 1e6;
  return {std::round(point.x * kSteps) / kSteps, std::round(point.y * kSteps) / kSteps};
}

cv::Point2d clamped(cv::Point2d point) {
  return {std::clamp(point.x, -kMaxCoordinate, kMaxCoordinate), std::clamp(point.y, -kMaxCoordinate, kMaxCoordinate)};
}

bool is_closed(const Mark& mark) {
  const auto* curve = std::get_if<project::Curve>(&mark);
  return curve != nullptr && curve->closed;
}

bool is_valid(const Feature& feature) {
  const auto good = [&](const Points& points) { return within_limits(points) && fits(feature.mark, points); };
  if (!std::ranges::all_of(feature.places, good)) return false;
  if (std::holds_alternative<project::Point>(feature.mark) || is_closed(feature.mark)) return true;
  return std::ranges::all_of(
      feature.places, [&](const Points& points) { return ends_meet(points) == ends_meet(feature.places.front()); });
}

bool move_point(Feature& feature, SideIndex side, std::size_t point, cv::Point2d to) {
  Points& points = points_of(feature, side);
  if (point >= points.size() || !finite(to)) return false;
  const bool both_ends = is_joined(feature) && (point == 0 || point + 1 == points.size());
  Points before = points;
  points[point] = clamped(to);
  if (both_ends) points.front() = points.back() = clamped(to);
  const bool good = is_valid(feature);
  if (!good) points = std::move(before);
  return good;
}

bool move_all(Feature& feature, SideIndex side, cv::Point2d by) {
  Points& points = points_of(feature, side);
  if (!finite(by)) return false;
  const auto [left, right] = std::ranges::minmax(points, {}, &cv::Point2d::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &cv::Point2d::y);
  const cv::Point2d step{limited(by.x, left.x, right.x), limited(by.y, top.y, bottom.y)};
  Points before = points;
  for (cv::Point2d& point : points) point = clamped(rounded_off(point + step));
  const bool good = is_valid(feature);
  if (!good) points = std::move(before);
  return good;
}

void reverse(Feature& feature, SideIndex side) {
  Points& points = points_of(feature, side);
  std::reverse(points.begin() + (is_closed(feature.mark) ? 1 : 0), points.end());
}

std::string_view kind_name(const Mark& mark) {
  constexpr std::array kWords{"line", "point", "curve"};
  return kWords[mark.index()];
}

std::string free_id(const project::Project& project, const Mark& mark) {
  std::set<std::string_view> taken;
  for (const Feature& feature : project.features) taken.insert(feature.id);
  for (std::size_t number = 1;; ++number) {
    std::string id = fmt::format("{} {}", kind_name(mark), number);
    if (!taken.contains(id)) return id;
  }
}

std::string problem_of_name(const std::string& name) {
  if (name.empty()) return "a name must not be empty";
  if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    return "a name must not hold control characters";
  try {
    static_cast<void>(json::quote(name));
  } catch (const Error&) {
    return "a name must be UTF-8";
  }
  return "";
}

}  // namespace morphkit::edit
