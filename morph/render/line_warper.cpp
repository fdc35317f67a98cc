#include "morph/render/line_warper.h"

#include <algorithm>

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

}  // namespace

LineWarper::LineWarper(std::span<const warp::FieldLine> lines, warp::FieldAccuracy accuracy, DissolveRange dissolve,
                       const Stage& stage)
    : Warper(stage, dissolve), field_(lines, static_cast<int>(stage.sides.size())), accuracy_(accuracy) {}

void LineWarper::positions(int top, std::span<warp::Map> maps, Pixels pixels, cv::Mat1f* dissolve) const {
  const cv::Size band = maps.front().size();
  field_.evaluate({0, top, band.width, band.height}, accuracy_, maps, dissolve);
  for (SideIndex side = 0; side < maps.size(); ++side) {
    const StageSide& picture = stage().sides[side];
    const Placement& placement = pixels == Pixels::kHeld ? picture.held : picture.file;
    for (int y = 0; y < band.height; ++y) to_image(placement, {maps[side][y], static_cast<std::size_t>(band.width)});
  }
}

LinePlan::LinePlan(const project::Project& project, const project::LinesMethod& method, const Stage& stage)
    : project_(project),
      method_(method),
      stage_(stage),
      pairs_(line_pairs(project, stage.sides[kSource].file, stage.sides[kDestination].file, stage.unit)) {
  const motion::Timing whole = *project::effective_pace(project_).dissolve;
  local_dissolve_ =
      std::any_of(pairs_.begin(), pairs_.end(), [&](const LinePair& pair) { return *pair.pace.dissolve != whole; });
}

std::unique_ptr<Warper> LinePlan::at(double t) const {
  return std::make_unique<LineWarper>(field_lines(pairs_, t, stage_.unit), method_.field, dissolve(t), stage_);
}

std::string LinePlan::label() const {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = counted(project_.features.size(), "feature") + " as " + counted(pairs_.size(), "line");
  if (project_.mesh) text += "; the mesh is not used, for the method is lines";
  return text;
}

DissolveRange LinePlan::dissolve(double t) const {
  const auto at = [&](const project::Pace& pace) { return std::clamp(motion::progress(*pace.dissolve, t), 0.0, 1.0); };
  if (!local_dissolve_) {
    const double whole = at(project::effective_pace(project_));
    return {whole, whole};
  }
  DissolveRange range{1, 0};
  for (const LinePair& pair : pairs_) {
    const double value = at(pair.pace);
    range = {std::min(range.least, value), std::max(range.most, value)};
  }
  return range;
}

}  // namespace morphkit::render
