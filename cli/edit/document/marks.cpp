#include "cli/edit/document/marks.h"

#include <algorithm>
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
using project::FeatureKind;
using project::kMaxCoordinate;
using render::SideName;

bool within_limits(const Points& points) {
  return std::ranges::all_of(points, [](cv::Point2d p) { return finite(p) && p == kept(p); });
}

bool ends_meet(const Points& points) {
  return points.front() == points.back();
}

/// Whether both ends of what is open lie at the same place, on both sides.
bool is_joined(const Feature& feature) {
  return feature.kind != FeatureKind::kPoint && !feature.closed && ends_meet(feature.source);
}

/// The nearest to `by` that lets `value` and all others stay within the limits.
double limited(double by, double least, double most) {
  return std::clamp(by, std::min(0.0, -kMaxCoordinate - least), std::max(0.0, kMaxCoordinate - most));
}

}  // namespace

Points& points_of(Feature& feature, SideName side) {
  return side == SideName::kSource ? feature.source : feature.destination;
}

const Points& points_of(const Feature& feature, SideName side) {
  return side == SideName::kSource ? feature.source : feature.destination;
}

bool finite(cv::Point2d point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

cv::Point2d settled(cv::Point2d point) {
  constexpr double kSteps = 1e6;
  return {std::round(point.x * kSteps) / kSteps, std::round(point.y * kSteps) / kSteps};
}

cv::Point2d kept(cv::Point2d point) {
  return {std::clamp(point.x, -kMaxCoordinate, kMaxCoordinate), std::clamp(point.y, -kMaxCoordinate, kMaxCoordinate)};
}

bool sound(const Feature& feature) {
  if (!within_limits(feature.source) || !within_limits(feature.destination)) return false;
  const std::size_t from = feature.source.size(), to = feature.destination.size();
  if (feature.kind == FeatureKind::kPoint) return from == 1 && to == 1;
  if (feature.kind == FeatureKind::kLine)
    return from == 2 && to == 2 && ends_meet(feature.source) == ends_meet(feature.destination);
  if (from > project::kMaxPoints || to > project::kMaxPoints) return false;
  if (motion::Curve::problem(feature.curve, feature.source, feature.closed)) return false;
  if (motion::Curve::problem(feature.curve, feature.destination, feature.closed)) return false;
  return feature.closed || ends_meet(feature.source) == ends_meet(feature.destination);
}

bool move_point(Feature& feature, SideName side, std::size_t point, cv::Point2d to) {
  Points& points = points_of(feature, side);
  if (point >= points.size() || !finite(to)) return false;
  const bool both_ends = is_joined(feature) && (point == 0 || point + 1 == points.size());
  Points before = points;
  points[point] = kept(to);
  if (both_ends) points.front() = points.back() = kept(to);
  const bool good = sound(feature);
  if (!good) points = std::move(before);
  return good;
}

bool move_all(Feature& feature, SideName side, cv::Point2d by) {
  Points& points = points_of(feature, side);
  if (!finite(by)) return false;
  const auto [left, right] = std::ranges::minmax(points, {}, &cv::Point2d::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &cv::Point2d::y);
  const cv::Point2d step{limited(by.x, left.x, right.x), limited(by.y, top.y, bottom.y)};
  Points before = points;
  for (cv::Point2d& point : points) point = kept(settled(point + step));
  const bool good = sound(feature);
  if (!good) points = std::move(before);
  return good;
}

void reverse(Feature& feature, SideName side) {
  Points& points = points_of(feature, side);
  std::reverse(points.begin() + (feature.closed ? 1 : 0), points.end());
}

std::string_view word_for(FeatureKind kind) {
  return kind == FeatureKind::kLine ? "line" : kind == FeatureKind::kPoint ? "point" : "curve";
}

std::string free_id(const project::Project& project, FeatureKind kind) {
  std::set<std::string_view> taken;
  for (const Feature& feature : project.features) taken.insert(feature.id);
  for (std::size_t number = 1;; ++number) {
    std::string id = fmt::format("{} {}", word_for(kind), number);
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
