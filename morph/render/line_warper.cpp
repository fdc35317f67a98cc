#include "morph/render/line_warper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "morph/render/line_check.h"

namespace morphkit::render {
namespace {

void to_image(const Placement& placement, std::span<warp::MapPoint> positions) {
  if (placement.is_identity()) return;
  for (warp::MapPoint& position : positions) {
    const cv::Point2d image = placement.to_image({position[0], position[1]});
    position = {static_cast<float>(image.x), static_cast<float>(image.y)};
  }
}

const cv::Point2d kCentre{0.5, 0.5};

/// Whether warp::LineField accepts the line.
bool in_range(const warp::Line& line) {
  constexpr double kMost = 1e9;
  return std::max({std::abs(line.p.x), std::abs(line.p.y), std::abs(line.q.x), std::abs(line.q.y)}) <= kMost;
}

LineWarper::Lines make_lines(const std::vector<project::MomentFeature>& features, const Stage& stage) {
  std::vector<Placement> placements;
  for (const StageSide& side : stage.sides) placements.push_back(side.file);
  return std::make_shared<const std::vector<FeatureLine>>(feature_lines(features, placements, stage.unit));
}

}  // namespace

LineWarper::LineWarper(const project::Moment& moment, Lines lines, std::vector<WeightRange> weights, const Stage& stage)
    : Warper(moment, stage, std::move(weights)),
      lines_(std::move(lines)),
      accuracy_(std::get<project::LinesMethod>(moment.method).field) {
  std::vector<warp::FieldLine> field = field_lines(*lines_, moment, stage.unit);
  const auto targets = static_cast<int>(stage.sides.size());
  fields_.emplace_back(field, targets);
  if (std::ranges::none_of(this->weights(), &WeightRange::is_local)) return;
  for (SideIndex side = 1; side + 1 < stage.sides.size(); ++side) {
    for (std::size_t i = 0; i < field.size(); ++i)
      field[i].value = moment.feature_weights[(*lines_)[i].feature].dissolve[side];
    fields_.emplace_back(field, targets);
  }
}

void LineWarper::positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const {
  const cv::Size size = maps.front().size();
  const cv::Rect band(0, top, size.width, size.height);
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) fields_[i + 1].evaluate(band, accuracy_, maps, &weights[i]);
  fields_.front().evaluate(band, accuracy_, maps, weights.empty() ? nullptr : &weights.back());
  for (SideIndex side = 0; side < maps.size(); ++side) {
    const StageSide& picture = stage().sides[side];
    const Placement& placement = pixels == Pixels::kHeld ? picture.held : picture.file;
    for (int y = 0; y < band.height; ++y) to_image(placement, {maps[side][y], static_cast<std::size_t>(band.width)});
  }
}

std::vector<Finding> LineWarper::problems() const {
  std::vector<Finding> findings = line_problems(moment(), *lines_, stage());
  std::ranges::move(map_folds(), std::back_inserter(findings));
  return findings;
}

std::string LineWarper::name_nearest(Finding& fold) const {
  fold.features = nearest_features(moment(), *lines_, fold.position);
  return fold.features.empty() ? "" : fmt::format("\"{}\"", fmt::join(fold.features, "\", \""));
}

/// The lines of `from` as the output and those of `to` as the target, all moved so that `centre` is the centre of pixel
/// (0, 0): the field is evaluated at pixel centres, and is most precise for small positions. A tiny line that rounding
/// makes a point on only one side carries no information and is left out.
std::vector<warp::FieldLine> LineWarper::lines_about(cv::Point2d centre, SideIndex from, SideIndex to) const {
  const cv::Point2d shift = kCentre - centre;
  std::vector<warp::FieldLine> lines;
  lines.reserve(lines_->size());
  for (const FeatureLine& line : *lines_) {
    const warp::Line &here = line.sides[from], &there = line.sides[to];
    const warp::Line output{here.p + shift, here.q + shift}, target{there.p + shift, there.q + shift};
    if ((output.p == output.q) != (target.p == target.q) || !in_range(output) || !in_range(target)) continue;
    const project::MomentFeature& feature = (*moment().features)[line.feature];
    warp::FieldLine field;
    field.output = output;
    field.targets = {target};
    field.weight = feature.weight;
    field.weight.unit = stage().unit;
    field.scale = feature.scale;
    lines.push_back(std::move(field));
  }
  return lines;
}

std::optional<cv::Point2d> LineWarper::carry(SideIndex from, SideIndex to, cv::Point2d point) const {
  const cv::Point2d here = stage().sides[from].file.to_canvas(point);
  const std::vector<warp::FieldLine> lines = lines_about(here, from, to);
  if (lines.empty()) return std::nullopt;
  std::array maps{warp::Map(1, 1)};
  warp::LineField(lines, 1).reference({0, 0, 1, 1}, maps);
  const warp::MapPoint at = maps[0](0, 0);
  const cv::Point2d there = cv::Point2d(at[0], at[1]) - kCentre + here;
  if (!std::isfinite(there.x) || !std::isfinite(there.y)) return std::nullopt;
  return stage().sides[to].file.to_image(there);
}

std::string LineWarper::label() const {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = counted(moment().features->size(), "feature") + " as " + counted(lines_->size(), "line");
  if (moment().mesh) text += "; the mesh is not used, for the method is lines";
  return text;
}

LinePlan::LinePlan(const project::Evaluator& moments, const Stage& stage)
    : stage_(stage), first_(moments.at(moments.clock().at(0))), lines_(make_lines(*first_.features, stage)) {}

LineWarper::Lines LinePlan::lines_of(const project::Moment& moment) const {
  return moment.features == first_.features ? lines_ : make_lines(*moment.features, stage_);
}

std::unique_ptr<Warper> LinePlan::at(const project::Moment& moment) const {
  return std::make_unique<LineWarper>(moment, lines_of(moment), weights(moment), stage_);
}

std::vector<WeightRange> LinePlan::weights(const project::Moment& moment) const {
  if (moment.features->empty()) return ranges_of({&moment.whole, 1});
  return ranges_of(moment.feature_weights);
}

}  // namespace morphkit::render
