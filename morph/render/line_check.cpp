#include "morph/render/line_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "morph/render/inbetween.h"

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

/// Where two segments cross in the inside of both; touching ends are no crossing.
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

std::vector<FeatureLine> lines_of(const Renderer& renderer, const project::Moment& moment) {
  std::vector<Placement> placements;
  for (const StageSide& side : renderer.stage().sides) placements.push_back(side.file);
  return feature_lines(*moment.features, placements);
}

class LineChecker {
 public:
  LineChecker(const Renderer& renderer, std::vector<Finding>& findings)
      : renderer_(renderer),
        moment_(renderer.moment(renderer.clock().at(0.5))),
        features_(*moment_.features),
        lines_(lines_of(renderer, moment_)),
        findings_(findings) {}

  void run() {
    find_crossings();
    find_twins();
    find_outside();
  }

 private:
  const std::string& id(const FeatureLine& line) const { return features_[line.feature].id; }

  void add(Finding finding, std::string message) {
    finding.message = std::move(message);
    findings_.push_back(std::move(finding));
  }

  void find_crossings() {
    const auto source = [](const FeatureLine& line) { return line.sides[kSource]; };
    const auto destination = [](const FeatureLine& line) { return line.sides[kDestination]; };
    const auto half = [&](const FeatureLine& line) { return between(line, moment_); };
    const Placement& on_source = renderer_.placement(kSource);
    const Placement& on_destination = renderer_.placement(kDestination);
    std::set<std::pair<std::size_t, std::size_t>>
        known;  // a pair that crosses on a side also does in between: said once
    find_crossings_of(
        source, "source", 0, [&](cv::Point2d x) { return on_source.to_image(x); }, known);
    find_crossings_of(
        destination, "destination", 1, [&](cv::Point2d x) { return on_destination.to_image(x); }, known);
    find_crossings_of(
        half, "in between", 0.5, [](cv::Point2d x) { return x; }, known);
  }

  template <typename LineOf, typename Place>
  void find_crossings_of(const LineOf& line_of, const char* where, double t, const Place& place,
                         std::set<std::pair<std::size_t, std::size_t>>& known) {
    std::vector<warp::Line> lines;
    lines.reserve(lines_.size());
    for (const FeatureLine& line : lines_) lines.push_back(line_of(line));
    std::set<std::pair<std::size_t, std::size_t>> here;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i + 1; j < lines_.size(); ++j) {
        const auto x = crossing(lines[i], lines[j]);
        const std::pair key{lines_[i].feature, lines_[j].feature};
        if (!x || (t == 0.5 && known.contains(key)) || !here.insert(key).second) continue;
        const cv::Point2d at = place(*x);
        Finding finding{Finding::Kind::kCrossing, true, where, {id(lines_[i]), id(lines_[j])}, {}, at, t, 0, 0, 0, {}};
        add(std::move(finding),
            key.first == key.second
                ? fmt::format("\"{}\" crosses itself at ({:.0f}, {:.0f}) {}", id(lines_[i]), at.x, at.y,
                              place_text(where))
                : fmt::format("\"{}\" and \"{}\" cross at ({:.0f}, {:.0f}) {}: pixels there are pulled two ways",
                              id(lines_[i]), id(lines_[j]), at.x, at.y, place_text(where)));
      }
    known.insert(here.begin(), here.end());
  }

  static std::string place_text(const std::string& where) { return where == "in between" ? where : "in the " + where; }

  void find_twins() {
    std::set<std::pair<std::size_t, std::size_t>> said;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i + 1; j < lines_.size(); ++j) {
        const FeatureLine &a = lines_[i], &b = lines_[j];
        if (a.feature == b.feature) continue;
        const bool in_source =
            are_twins(a.sides[kSource], a.sides[kDestination], b.sides[kSource], b.sides[kDestination]);
        if (!in_source && !are_twins(a.sides[kDestination], a.sides[kSource], b.sides[kDestination], b.sides[kSource]))
          continue;
        if (!said.insert({a.feature, b.feature}).second) continue;
        const SideIndex side = in_source ? kSource : kDestination;
        const warp::Line& line = in_source ? a.sides[kSource] : a.sides[kDestination];
        const std::string where = in_source ? "source" : "destination";
        const cv::Point2d at = renderer_.placement(side).to_image((line.p + line.q) / 2.0);
        add({Finding::Kind::kTwins, true, where, {id(a), id(b)}, {}, at, in_source ? 0.0 : 1.0, 0, 0, 0, {}},
            fmt::format(
                "\"{}\" and \"{}\" lie almost on each other at ({:.0f}, {:.0f}) in the {} but lead to different "
                "places: remove one or move them apart",
                id(a), id(b), at.x, at.y, where));
      }
  }

  void find_outside() {
    for (const project::MomentFeature& feature : features_) {
      const bool source_cropped = find_outside(feature, kSource, feature.places[kSource], "source");
      const bool destination_cropped = find_outside(feature, kDestination, feature.places[kDestination], "destination");
      if (source_cropped && destination_cropped)
        add({Finding::Kind::kOutsideCanvas, false, "in between", {feature.id}, {}, {}, 0, 0, 0, 0, {}},
            fmt::format("\"{}\" lies outside the canvas on both sides: the output's size and fit crop it", feature.id));
    }
  }

  /// Reports the first point outside the picture. @return whether all points are off the canvas.
  bool find_outside(const project::MomentFeature& feature, SideIndex side, const std::vector<cv::Point2d>& points,
                    const char* where) {
    const cv::Rect2d picture({0, 0}, cv::Size2d(renderer_.picture_size(side)));
    const cv::Rect2d canvas({0, 0}, cv::Size2d(renderer_.size()));
    const auto inside = [](const cv::Rect2d& r, cv::Point2d x) {
      return x.x >= r.x && x.y >= r.y && x.x <= r.x + r.width && x.y <= r.y + r.height;
    };
    const auto out = std::find_if(points.begin(), points.end(), [&](cv::Point2d x) { return !inside(picture, x); });
    if (out != points.end())
      add({Finding::Kind::kOutsideImage, true, where, {feature.id}, {}, *out, 0, 0, 0, 0, {}},
          fmt::format("\"{}\" has a point ({:g}, {:g}) outside the {} picture, which is {}x{}", feature.id, out->x,
                      out->y, where, picture.width, picture.height));
    return std::none_of(points.begin(), points.end(),
                        [&](cv::Point2d x) { return inside(canvas, renderer_.placement(side).to_canvas(x)); });
  }

  const Renderer& renderer_;
  const project::Moment moment_;
  const std::vector<project::MomentFeature>& features_;
  std::vector<FeatureLine> lines_;
  std::vector<Finding>& findings_;
};

}  // namespace

void check_lines(const Renderer& renderer, std::vector<Finding>& findings) {
  LineChecker(renderer, findings).run();
}

std::vector<std::string> nearest_features(const Renderer& renderer, cv::Point2d position, project::Time time) {
  constexpr int kNearestFeatures = 3;
  const project::Moment moment = renderer.moment(time);
  std::vector<std::pair<double, std::size_t>> distances;
  for (const FeatureLine& line : lines_of(renderer, moment))
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
