#include "morph/render/line_warper.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace morphkit::render {
namespace {

void to_image(const Placement& placement, std::span<warp::MapPoint> positions) {
  if (placement.is_identity()) return;
  for (warp::MapPoint& position : positions) {
    const cv::Point2d image = placement.to_image({position[0], position[1]});
    position = {static_cast<float>(image.x), static_cast<float>(image.y)};
  }
}

std::shared_ptr<const std::vector<FeatureLine>> make_lines(const std::vector<project::MomentFeature>& features,
                                                           const Stage& stage) {
  std::vector<Placement> placements;
  for (const StageSide& side : stage.sides) placements.push_back(side.file);
  return std::make_shared<const std::vector<FeatureLine>>(feature_lines(features, placements, stage.unit));
}

}  // namespace

LineWarper::LineWarper(const project::Moment& moment, const std::vector<FeatureLine>& lines,
                       std::vector<WeightRange> weights, const Stage& stage)
    : Warper(stage, std::move(weights)), accuracy_(std::get<project::LinesMethod>(moment.method).field) {
  std::vector<warp::FieldLine> field = field_lines(lines, moment, stage.unit);
  const auto targets = static_cast<int>(stage.sides.size());
  fields_.emplace_back(field, targets);
  if (std::ranges::none_of(this->weights(), &WeightRange::is_local)) return;
  for (SideIndex side = 1; side + 1 < stage.sides.size(); ++side) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      field[i].value = moment.feature_weights[lines[i].feature].dissolve[side];
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

LinePlan::LinePlan(const project::Evaluator& moments, const Stage& stage)
    : stage_(stage), first_(moments.at(moments.clock().at(0))) {
  lines_ = make_lines(*first_.features, stage);
}

LinePlan::Lines LinePlan::lines_of(const project::Moment& moment) const {
  return moment.features == first_.features ? lines_ : make_lines(*moment.features, stage_);
}

std::unique_ptr<Warper> LinePlan::at(const project::Moment& moment) const {
  return std::make_unique<LineWarper>(moment, *lines_of(moment), weights(moment), stage_);
}

std::vector<WeightRange> LinePlan::weights(const project::Moment& moment) const {
  if (moment.features->empty()) return ranges_of({&moment.whole, 1});
  return ranges_of(moment.feature_weights);
}

std::string LinePlan::label() const {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = counted(first_.features->size(), "feature") + " as " + counted(lines_->size(), "line");
  if (first_.mesh) text += "; the mesh is not used, for the method is lines";
  return text;
}

}  // namespace morphkit::render
