#include "morph/render/inbetween.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "morph/motion/curve.h"

namespace morphkit::render {
namespace {

/// The allowed distance of a chain of chords from its curve, and the largest number of chords. Every chord pulls like a
/// separate line, so chains are kept short.
constexpr double kChordTolerancePx = 0.75;
constexpr int kMaxChords = 48;

std::vector<cv::Point2d> on_canvas(const std::vector<cv::Point2d>& points, const Placement& placement) {
  std::vector<cv::Point2d> result;
  result.reserve(points.size());
  for (const cv::Point2d& point : points) result.push_back(placement.to_canvas(point));
  return result;
}

/// How far each side's line is turned from the first one, rad: from side to side the shorter way, and `turns` more.
std::vector<double> turned(const std::vector<warp::Line>& sides, double turns) {
  std::vector<double> result{0};
  for (std::size_t side = 1; side < sides.size(); ++side) {
    const cv::Point2d from = sides[side - 1].q - sides[side - 1].p, to = sides[side].q - sides[side].p;
    // The shorter way round, in (-pi, pi]: remainder() maps a half turn to either sign, so name one.
    double turn = std::remainder(std::atan2(to.y, to.x) - std::atan2(from.y, from.x), 2 * std::numbers::pi);
    if (turn <= -std::numbers::pi) turn += 2 * std::numbers::pi;
    result.push_back(result.back() + (turn + 2 * std::numbers::pi * turns));
  }
  return result;
}

warp::Line between_centres(const std::vector<warp::Line>& sides, std::span<const double> weights, double turns) {
  const cv::Point2d first = sides.front().q - sides.front().p;
  const std::vector<double> turn = turned(sides, turns);
  const double angle_rad = std::atan2(first.y, first.x) + mean(weights, [&](std::size_t side) { return turn[side]; });
  const auto length = [&](std::size_t side) {
    const cv::Point2d arm = sides[side].q - sides[side].p;
    return std::hypot(arm.x, arm.y);
  };
  const double half = mean(weights, length) / 2;
  const cv::Point2d centre =
      mean(weights, [&](std::size_t side) { return cv::Point2d((sides[side].p + sides[side].q) / 2.0); });
  const cv::Point2d arm{half * std::cos(angle_rad), half * std::sin(angle_rad)};
  return {centre - arm, centre + arm};
}

/// The side that has all the weight; nullptr if none has.
const warp::Line* whole_side(const std::vector<warp::Line>& sides, std::span<const double> weights) {
  const auto weighs = [](double weight) { return weight != 0; };
  const auto first = std::ranges::find_if(weights, weighs);
  if (std::find_if(first + 1, weights.end(), weighs) != weights.end()) return nullptr;
  return &sides[static_cast<std::size_t>(first - weights.begin())];
}

/// A chain of lines with equal arc length on every side.
void append_curve(const project::MomentFeature& feature, const project::Curve& curve, std::size_t index,
                  std::span<const Placement> placements, double unit, std::vector<FeatureLine>& lines) {
  const double tolerance = kChordTolerancePx / unit;
  int chords = curve.closed ? 3 : 1;
  std::vector<motion::Curve> curves;
  for (std::size_t side = 0; side < placements.size(); ++side) {
    curves.emplace_back(curve.kind, on_canvas(feature.places[side], placements[side]), curve.closed);
    chords = std::max(chords, motion::chords_needed(curves.back(), tolerance, kMaxChords));
  }
  const std::size_t first = lines.size();
  lines.resize(first + static_cast<std::size_t>(chords), {{}, index});
  for (const motion::Curve& side : curves) {
    const std::vector<cv::Point2d> points = motion::equal_arc_points(side, chords);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) lines[first + i].sides.push_back({points[i], points[i + 1]});
  }
}

}  // namespace

std::vector<FeatureLine> feature_lines(const std::vector<project::MomentFeature>& features,
                                       std::span<const Placement> placements, double unit) {
  std::vector<FeatureLine> lines;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const project::MomentFeature& feature = features[i];
    if (const auto* curve = std::get_if<project::Curve>(&feature.mark)) {
      append_curve(feature, *curve, i, placements, unit, lines);
      continue;
    }
    FeatureLine line{{}, i};
    for (std::size_t side = 0; side < placements.size(); ++side) {
      const project::Points& place = feature.places[side];
      line.sides.push_back({placements[side].to_canvas(place.front()), placements[side].to_canvas(place.back())});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

warp::Line between(const FeatureLine& line, const project::MomentFeature& feature, std::span<const double> weights) {
  const std::vector<warp::Line>& sides = line.sides;
  if (const warp::Line* whole = whole_side(sides, weights)) return *whole;
  const bool unchanged =
      std::ranges::all_of(sides, [&](const warp::Line& side) { return side.p == sides[0].p && side.q == sides[0].q; });
  if (feature.between == project::Between::kCentre && !(unchanged && feature.turns == 0))
    return between_centres(sides, weights, feature.turns);
  return {mean(weights, [&](std::size_t side) { return sides[side].p; }),
          mean(weights, [&](std::size_t side) { return sides[side].q; })};
}

warp::Line between(const FeatureLine& line, const project::Moment& moment) {
  return between(line, (*moment.features)[line.feature], moment.feature_weights[line.feature].shape);
}

std::vector<warp::FieldLine> field_lines(const std::vector<FeatureLine>& lines, const project::Moment& moment,
                                         double unit) {
  std::vector<warp::FieldLine> result;
  result.reserve(lines.size());
  for (const FeatureLine& line : lines) {
    const project::MomentFeature& feature = (*moment.features)[line.feature];
    warp::FieldLine field;
    field.output = between(line, moment);
    field.targets = line.sides;
    field.weight = feature.weight;
    field.weight.unit = unit;
    field.scale = feature.scale;
    field.value = moment.feature_weights[line.feature].dissolve.back();
    result.push_back(std::move(field));
  }
  return result;
}

}  // namespace morphkit::render
