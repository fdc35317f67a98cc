#include "morph/render/line_morpher.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/parallel.h"
#include "morph/render/dissolve.h"
#include "warp/image/image_pool.h"

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

/// What all rows of a frame share.
struct LineMorpher::Moment {
  warp::LineField field;
  float dissolve;
  bool local_dissolve;  ///< false also at the ends, where all features agree
  bool needs_source, needs_destination;
};

LineMorpher::LineMorpher(const project::Project& project, const Stage& stage)
    : project_(project),
      stage_(stage),
      pairs_(line_pairs(project, stage.source.file, stage.destination.file, stage.unit)) {
  const motion::Timing whole = *project::effective_pace(project_).dissolve;
  local_dissolve_ =
      std::any_of(pairs_.begin(), pairs_.end(), [&](const LinePair& pair) { return *pair.pace.dissolve != whole; });
}

std::string LineMorpher::description() const {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = counted(project_.features.size(), "feature") + " as " + counted(pairs_.size(), "line");
  if (project_.mesh) text += "; the mesh is not used, for the method is lines";
  return text;
}

std::pair<double, double> LineMorpher::dissolve_range(double t) const {
  const auto at = [&](const project::Pace& pace) { return std::clamp(motion::progress(*pace.dissolve, t), 0.0, 1.0); };
  if (!local_dissolve_) {
    const double whole = at(project::effective_pace(project_));
    return {whole, whole};
  }
  std::pair<double, double> range{1, 0};
  for (const LinePair& pair : pairs_) {
    const double value = at(pair.pace);
    range = {std::min(range.first, value), std::max(range.second, value)};
  }
  return range;
}

bool LineMorpher::shows(SideIndex side, double t) const {
  const auto [least, most] = dissolve_range(t);
  return side == kSource ? least < 1 : most > 0;
}

warp::Image LineMorpher::frame(double t) const {
  const std::vector<warp::FieldLine> lines = field_lines(pairs_, t, stage_.unit);
  const auto [least, most] = dissolve_range(t);
  const Moment moment{warp::LineField(lines, 2), static_cast<float>(least), least != most, least<1, most> 0};
  warp::Image out = warp::pooled_image(stage_.size);
  for_rows(
      out.rows,
      [&](int begin, int end) {
        warp::Image band = out.rowRange(begin, end);
        render_band(moment, begin, band);
      },
      warp::kSampleBand);
  return out;
}

void LineMorpher::sample_side(const StageSide& side, warp::Map& positions, warp::Image& out) const {
  for (int y = 0; y < positions.rows; ++y)
    to_image(side.held, {positions[y], static_cast<std::size_t>(positions.cols)});
  warp::sample_band(side.image, positions, {project_.warp.filter, side.border}, out);
}

void LineMorpher::render_band(const Moment& moment, int top, warp::Image& out) const {
  // Kept from band to band; only their sizes matter between uses.
  struct Scratch {
    warp::Map source, destination;
    warp::Image pixels;
    cv::Mat1f dissolve;
  };
  thread_local Scratch scratch;
  scratch.source.create(out.size());
  scratch.destination.create(out.size());
  scratch.pixels.create(out.size());
  if (moment.local_dissolve) scratch.dissolve.create(out.size());

  std::array positions{scratch.source, scratch.destination};
  moment.field.evaluate({0, top, out.cols, out.rows}, project_.warp.lines.field, positions,
                        moment.local_dissolve ? &scratch.dissolve : nullptr);
  if (!moment.needs_source) return sample_side(stage_.destination, scratch.destination, out);
  sample_side(stage_.source, scratch.source, out);
  if (!moment.needs_destination) return;
  sample_side(stage_.destination, scratch.destination, scratch.pixels);
  const auto width = static_cast<std::size_t>(out.cols);
  for (int y = 0; y < out.rows; ++y) {
    const std::span<const float> alpha =
        moment.local_dissolve ? std::span<const float>(scratch.dissolve[y], width) : std::span(&moment.dissolve, 1);
    dissolve_row({out[y], width}, {scratch.pixels[y], width}, alpha, project_.blend);
  }
}

warp::Map LineMorpher::map(double t, SideIndex side_name) const {
  const warp::LineField field(field_lines(pairs_, t, stage_.unit), 2);
  warp::Map map(stage_.size);
  for_rows(
      map.rows,
      [&](int begin, int end) {
        warp::Map wanted = map.rowRange(begin, end);
        const warp::Map rest(wanted.size());
        const bool first = side_name == kSource;
        std::array positions{first ? wanted : rest, first ? rest : wanted};
        field.evaluate({0, begin, map.cols, end - begin}, project_.warp.lines.field, positions);
        for (int y = 0; y < wanted.rows; ++y)
          to_image(stage_.side(side_name).file, {wanted[y], static_cast<std::size_t>(wanted.cols)});
      },
      warp::kFieldTile);
  return map;
}

}  // namespace morphkit::render
