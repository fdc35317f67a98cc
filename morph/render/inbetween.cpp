#include "morph/render/inbetween.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

warp::Line between_centres(const LinePair& pair, double s, double turns) {
  const cv::Point2d from = pair.source.q - pair.source.p;
  const cv::Point2d to = pair.destination.q - pair.destination.p;
  const double angle_from = std::atan2(from.y, from.x);
  // The shorter way round, in (-pi, pi]: remainder() maps a half turn to either sign, so name one.
  double turn = std::remainder(std::atan2(to.y, to.x) - angle_from, 2 * std::numbers::pi);
  if (turn <= -std::numbers::pi) turn += 2 * std::numbers::pi;
  const double angle_rad = angle_from + s * (turn + 2 * std::numbers::pi * turns);
  const double half = std::lerp(std::hypot(from.x, from.y), std::hypot(to.x, to.y), s) / 2;
  const cv::Point2d centre =
      lerp((pair.source.p + pair.source.q) / 2.0, (pair.destination.p + pair.destination.q) / 2.0, s);
  const cv::Point2d arm{half * std::cos(angle_rad), half * std::sin(angle_rad)};
  return {centre - arm, centre + arm};
}

void append_curve(const project::Feature& feature, const project::Curve& curve, const Placement& source,
                  const Placement& destination, const LinePair& prototype, double unit, std::vector<LinePair>& pairs) {
  const motion::Curve from(curve.kind, on_canvas(feature.places[project::kSource], source), curve.closed);
  const motion::Curve to(curve.kind, on_canvas(feature.places[project::kDestination], destination), curve.closed);
  const double tolerance = kChordTolerancePx / unit;
  const int chords = std::max({motion::chords_needed(from, tolerance, kMaxChords),
                               motion::chords_needed(to, tolerance, kMaxChords), curve.closed ? 3 : 1});
  const std::vector<cv::Point2d> a = motion::equal_arc_points(from, chords);
  const std::vector<cv::Point2d> b = motion::equal_arc_points(to, chords);
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    LinePair pair = prototype;
    pair.source = {a[i], a[i + 1]};
    pair.destination = {b[i], b[i + 1]};
    pairs.push_back(std::move(pair));
  }
}

}  // namespace

std::vector<LinePair> line_pairs(const project::Project& project, const Placement& source, const Placement& destination,
                                 double unit) {
  std::vector<LinePair> pairs;
  for (std::size_t i = 0; i < project.features.size(); ++i) {
    const project::Feature& feature = project.features[i];
    LinePair pair;
    pair.pull = project::effective_pull(project, feature);
    pair.pace = project::effective_pace(project, feature);
    pair.feature = static_cast<int>(i);
    if (const auto* curve = std::get_if<project::Curve>(&feature.mark)) {
      append_curve(feature, *curve, source, destination, pair, unit, pairs);
      continue;
    }
    const std::vector<cv::Point2d> a = on_canvas(feature.places[project::kSource], source);
    const std::vector<cv::Point2d> b = on_canvas(feature.places[project::kDestination], destination);
    pair.source = {a.front(), a.back()};
    pair.destination = {b.front(), b.back()};
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

warp::Line between(const LinePair& pair, double s) {
  if (s == 0) return pair.source;
  if (s == 1) return pair.destination;
  const bool unchanged = pair.source.p == pair.destination.p && pair.source.q == pair.destination.q;
  const double turns = pair.pull.turns.value_or(0);
  if (*pair.pull.between == project::Between::kCentre && !(unchanged && turns == 0))
    return between_centres(pair, s, turns);
  return {lerp(pair.source.p, pair.destination.p, s), lerp(pair.source.q, pair.destination.q, s)};
}

std::vector<warp::FieldLine> field_lines(const std::vector<LinePair>& pairs, double t, double unit) {
  std::vector<warp::FieldLine> lines;
  lines.reserve(pairs.size());
  for (const LinePair& pair : pairs) {
    warp::FieldLine line;
    line.output = between(pair, motion::progress(*pair.pace.shape, t));
    line.targets = {pair.source, pair.destination};
    line.weight = {*pair.pull.a, *pair.pull.b, *pair.pull.p, unit};
    line.scale = *pair.pull.scale;
    line.value = std::clamp(motion::progress(*pair.pace.dissolve, t), 0.0, 1.0);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace morphkit::render
