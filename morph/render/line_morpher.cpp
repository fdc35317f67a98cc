#include "morph/render/line_morpher.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "morph/render/dissolve.h"
#include "warp/image_pool.h"
#include "warp/parallel.h"

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
    : project_(project), stage_(stage), pairs_(line_pairs(project, stage.source.file, stage.destination.file)) {
  const motion::Timing whole = *project::effective(project_).dissolve;
  local_dissolve_ = std::any_of(pairs_.begin(), pairs_.end(),
                                [&](const LinePair& pair) { return *pair.influence.dissolve != whole; });
}

std::string LineMorpher::description() const {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = counted(project_.features.size(), "feature") + " as " + counted(pairs_.size(), "line");
  if (project_.mesh) text += "; the mesh is not used, for the method is lines";
  return text;
}

warp::Image LineMorpher::frame(double t) const {
  const std::vector<warp::FieldLine> lines = field_lines(pairs_, t);
  const double whole = std::clamp(motion::progress(*project::effective(project_).dissolve, t), 0.0, 1.0);
  const auto [least, most] =
      std::minmax_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  const bool local = local_dissolve_ && least->value != most->value;
  const double dissolve = local_dissolve_ ? least->value : whole;
  const Moment moment{warp::LineField(lines, 2), static_cast<float>(dissolve), local,
                      (local ? least->value : dissolve) < 1, (local ? most->value : dissolve) > 0};
  warp::Image out = warp::pooled_image(stage_.size);
  warp::for_rows(out.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) render_row(moment, y, {out[y], static_cast<std::size_t>(out.cols)});
  });
  return out;
}

void LineMorpher::sample_side(const StageSide& side, std::span<warp::MapPoint> positions,
                              std::span<warp::Pixel> out) const {
  to_image(side.held, positions);
  warp::sample_row(side.image, positions, {project_.warp.filter, side.border}, out);
}

void LineMorpher::render_row(const Moment& moment, int y, std::span<warp::Pixel> out) const {
  struct Scratch {
    std::vector<warp::MapPoint> source, destination;
    std::vector<warp::Pixel> pixels;
    std::vector<float> dissolve;
  };
  // Kept from row to row; only its sizes matter between uses.
  thread_local Scratch scratch;
  scratch.source.resize(out.size());
  scratch.destination.resize(out.size());
  scratch.pixels.resize(out.size());
  scratch.dissolve.resize(moment.local_dissolve ? out.size() : 0);

  const std::array<std::span<warp::MapPoint>, 2> positions{scratch.source, scratch.destination};
  moment.field.row(y, 0, positions, scratch.dissolve);
  if (!moment.needs_source) {
    sample_side(stage_.destination, scratch.destination, out);
    return;
  }
  sample_side(stage_.source, scratch.source, out);
  if (!moment.needs_destination) return;
  sample_side(stage_.destination, scratch.destination, scratch.pixels);
  const std::span<const float> alpha =
      moment.local_dissolve ? std::span<const float>(scratch.dissolve) : std::span<const float>(&moment.dissolve, 1);
  dissolve_row(out, scratch.pixels, alpha, project_.blend);
}

warp::Map LineMorpher::map(double t, SideName side_name) const {
  const warp::LineField field(field_lines(pairs_, t), 2);
  warp::Map map(stage_.size);
  warp::for_rows(map.rows, [&](int begin, int end) {
    std::vector<warp::MapPoint> other(static_cast<std::size_t>(map.cols));
    for (int y = begin; y < end; ++y) {
      const std::span<warp::MapPoint> wanted(map[y], other.size());
      const std::span<warp::MapPoint> rest(other);
      const bool first = side_name == SideName::kSource;
      field.row(y, 0, std::array<std::span<warp::MapPoint>, 2>{first ? wanted : rest, first ? rest : wanted});
      to_image(stage_.side(side_name).file, wanted);
    }
  });
  return map;
}

}  // namespace morphkit::render
