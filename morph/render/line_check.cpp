#include "morph/render/line_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "morph/render/warper.h"

namespace morphkit::render {
namespace {

/// Lines or points closer than this, more parallel than this, and leading further apart than this are twins.
constexpr double kTwinDistancePx = 4;
constexpr double kTwinSine = 0.17;  // 10 degrees
constexpr double kTwinSpreadPx = 8;

double cross(cv::Point2d a, cv::Point2d b) {
  return a.x * b.y - a.y * b.x;
}

double distance(cv::Point2d a, cv::Point2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The interior crossing of two segments; touching ends do not count.
std::optional<cv::Point2d> crossing(const warp::Line& a, const warp::Line& b) {
  const cv::Point2d da = a.q - a.p, db = b.q - b.p;
  const double denominator = cross(da, db);
  if (denominator == 0) return std::nullopt;
  const double u = cross(b.p - a.p, db) / denominator;
  const double v = cross(b.p - a.p, da) / denominator;
  constexpr double kEnd = 1e-6;
  if (u <= kEnd || u >= 1 - kEnd || v <= kEnd || v >= 1 - kEnd) return std::nullopt;
  return a.p + u * da;
}

double distance_to(const warp::Line& line, cv::Point2d x) {
  const cv::Point2d d = line.q - line.p;
  const double length2 = d.dot(d);
  const double u = length2 > 0 ? std::clamp((x - line.p).dot(d) / length2, 0.0, 1.0) : 0;
  return distance(x, line.p + u * d);
}

double length(const warp::Line& line) {
  return distance(line.p, line.q);
}

/// Nearly in the same place, and nearly parallel if they are not points.
bool overlap(const warp::Line& shorter, const warp::Line& longer) {
  const double lengths = length(shorter) * length(longer);
  if (lengths == 0) return length(longer) == 0 && distance(shorter.p, longer.p) < kTwinDistancePx;
  if (std::abs(cross(shorter.q - shorter.p, longer.q - longer.p)) > kTwinSine * lengths) return false;
  return distance_to(longer, shorter.p) < kTwinDistancePx && distance_to(longer, shorter.q) < kTwinDistancePx;
}

/// Where a line and its partner carry a position, Beier and Neely 1992, sec. 3.1.
cv::Point2d carried(const warp::Line& from, const warp::Line& to, cv::Point2d x) {
  const cv::Point2d d = from.q - from.p, d_to = to.q - to.p;
  const double size = length(from), size_to = length(to);
  if (size == 0 || size_to == 0) return x + (to.p - from.p);
  const double u = (x - from.p).dot(d) / (size * size);
  const double v = cross(d, x - from.p) / size;
  return to.p + u * d_to + v / size_to * cv::Point2d(-d_to.y, d_to.x);
}

/// Whether two pairs lie on each other on one side (`from`) but lead to different places on the other.
bool are_twins(const warp::Line& from_a, const warp::Line& to_a, const warp::Line& from_b, const warp::Line& to_b) {
  if (length(from_a) > length(from_b)) return are_twins(from_b, to_b, from_a, to_a);
  if (!overlap(from_a, from_b)) return false;
  return distance(carried(from_b, to_b, from_a.p), to_a.p) >= kTwinSpreadPx ||
         distance(carried(from_b, to_b, from_a.q), to_a.q) >= kTwinSpreadPx;
}

/// Whether they lie on each other on the side `from` but lead to different places on another one.
bool are_twins(const FeatureLine& a, const FeatureLine& b, SideIndex from) {
  for (SideIndex to = 0; to < a.sides.size(); ++to)
    if (to != from && are_twins(a.sides[from], a.sides[to], b.sides[from], b.sides[to])) return true;
  return false;
}

class LineChecker {
 public:
  LineChecker(const project::Moment& moment, const std::vector<FeatureLine>& lines, const Stage& stage)
      : moment_(moment), lines_(lines), stage_(stage) {}

  std::vector<Finding> run() {
    find_crossings();
    find_twins();
    for (const project::MomentFeature& feature : *moment_.features) find_outside(feature);
    return std::move(findings_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  const std::string& id(std::size_t line) const { return (*moment_.features)[lines_[line].feature].id; }

  /// A finding on one picture.
  Finding found(Finding::Kind kind, SideIndex side, std::vector<std::string> features, cv::Point2d position) const {
    Finding finding;
    finding.kind = kind;
    finding.where = name_of(side);
    finding.features = std::move(features);
    finding.position = position;
    finding.t = end_of(side, stage_.sides.size());
    return finding;
  }

  void find_crossings() {
    std::vector<warp::Line> lines(lines_.size());
    std::set<Pair> known;  // a pair that crosses on a side also does in between: said once
    for (SideIndex side = 0; side < stage_.sides.size(); ++side) {
      std::ranges::transform(lines_, lines.begin(), [&](const FeatureLine& line) { return line.sides[side]; });
      std::set<Pair> here;
      find_crossings(lines, here, [&](std::size_t i, std::size_t j, cv::Point2d x) {
        return found(Finding::Kind::kCrossing, side, {id(i), id(j)}, stage_.sides[side].file.to_image(x));
      });
      known.merge(here);
    }
    std::ranges::transform(lines_, lines.begin(), [&](const FeatureLine& line) { return between(line, moment_); });
    find_crossings(lines, known, [&](std::size_t i, std::size_t j, cv::Point2d x) {
      Finding finding = found(Finding::Kind::kCrossing, 0, {id(i), id(j)}, x);
      finding.where = kInBetween;
      finding.t = moment_.time.t;
      return finding;
    });
  }

  /// @param known  pairs of features that are not told again. @param finding_of  makes the finding of two lines.
  template <typename FindingOf>
  void find_crossings(const std::vector<warp::Line>& lines, std::set<Pair>& known, const FindingOf& finding_of) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = i + 1; j < lines.size(); ++j) {
        const auto x = crossing(lines[i], lines[j]);
        if (!x || !known.insert({lines_[i].feature, lines_[j].feature}).second) continue;
        Finding finding = finding_of(i, j, *x);
        finding.message = crossing_text(finding);
        findings_.push_back(std::move(finding));
      }
  }

  static std::string crossing_text(const Finding& finding) {
    const std::string where = finding.where == kInBetween ? finding.where : "in the " + finding.where;
    const std::string &a = finding.features[0], &b = finding.features[1];
    const cv::Point2d at = finding.position;
    if (a == b) return fmt::format("\"{}\" crosses itself at ({:.0f}, {:.0f}) {}", a, at.x, at.y, where);
    return fmt::format("\"{}\" and \"{}\" cross at ({:.0f}, {:.0f}) {}: pixels there are pulled two ways", a, b, at.x,
                       at.y, where);
  }

  void find_twins() {
    std::set<Pair> said;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i + 1; j < lines_.size(); ++j) {
        const FeatureLine &a = lines_[i], &b = lines_[j];
        if (a.feature == b.feature) continue;
        SideIndex side = 0;
        while (side < stage_.sides.size() && !are_twins(a, b, side)) ++side;
        if (side == stage_.sides.size() || !said.insert({a.feature, b.feature}).second) continue;
        const warp::Line& line = a.sides[side];
        const cv::Point2d at = stage_.sides[side].file.to_image((line.p + line.q) / 2.0);
        Finding finding = found(Finding::Kind::kTwins, side, {id(i), id(j)}, at);
        finding.message = fmt::format(
            "\"{}\" and \"{}\" lie almost on each other at ({:.0f}, {:.0f}) in the {} but lead to different "
            "places: remove one or move them apart",
            id(i), id(j), at.x, at.y, finding.where);
        findings_.push_back(std::move(finding));
      }
  }

  void find_outside(const project::MomentFeature& feature) {
    bool cropped = true;
    for (SideIndex side = 0; side < stage_.sides.size(); ++side) {
      find_outside(feature, side);
      cropped = cropped && is_cropped(feature.places[side], stage_.sides[side].file);
    }
    if (!cropped) return;
    Finding finding = found(Finding::Kind::kOutsideCanvas, 0, {feature.id}, {});
    finding.warning = false;
    finding.where = kInBetween;
    finding.message = fmt::format("\"{}\" lies outside the canvas on {} sides: the output's size and fit crop it",
                                  feature.id, stage_.sides.size() == 2 ? "both" : "all");
    findings_.push_back(std::move(finding));
  }

  static bool inside(cv::Size size, cv::Point2d x) {
    return x.x >= 0 && x.y >= 0 && x.x <= size.width && x.y <= size.height;
  }

  /// Reports the first point outside the picture.
  void find_outside(const project::MomentFeature& feature, SideIndex side) {
    const cv::Size size = stage_.sides[side].file_size;
    const project::Points& points = feature.places[side];
    const auto out = std::ranges::find_if(points, [&](cv::Point2d x) { return !inside(size, x); });
    if (out == points.end()) return;
    Finding finding = found(Finding::Kind::kOutsideImage, side, {feature.id}, *out);
    finding.t = 0;
    finding.message = fmt::format("\"{}\" has a point ({:g}, {:g}) outside the {} picture, which is {}x{}", feature.id,
                                  out->x, out->y, finding.where, size.width, size.height);
    findings_.push_back(std::move(finding));
  }

  bool is_cropped(const project::Points& points, const Placement& placement) const {
    return std::ranges::none_of(points, [&](cv::Point2d x) { return inside(stage_.size, placement.to_canvas(x)); });
  }

  const project::Moment& moment_;
  const std::vector<FeatureLine>& lines_;
  const Stage& stage_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> line_problems(const project::Moment& moment, const std::vector<FeatureLine>& lines,
                                   const Stage& stage) {
  return LineChecker(moment, lines, stage).run();
}

std::vector<std::string> nearest_features(const project::Moment& moment, const std::vector<FeatureLine>& lines,
                                          cv::Point2d position) {
  constexpr int kNearestFeatures = 3;
  std::vector<std::pair<double, std::size_t>> distances;
  distances.reserve(lines.size());
  for (const FeatureLine& line : lines)
    distances.emplace_back(distance_to(between(line, moment), position), line.feature);
  std::sort(distances.begin(), distances.end());
  std::vector<std::string> ids;
  for (const auto& [distance, feature] : distances) {
    const std::string& name = (*moment.features)[feature].id;
    if (std::find(ids.begin(), ids.end(), name) == ids.end()) ids.push_back(name);
    if (ids.size() == kNearestFeatures) break;
  }
  return ids;
}

}  // namespace morphkit::render
