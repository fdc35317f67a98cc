#include "morph/render/mesh_morpher.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "morph/error.h"
#include "morph/render/dissolve.h"
#include "warp/parallel.h"

namespace morphkit::render {
namespace {

constexpr const char* kAllow = "; move it back into order, or render what can be rendered with --allow-folds";

const char* name_of(SideName side) {
  return side == SideName::kSource ? "source" : "destination";
}

/// In pixels of the picture as it is held: reduced, or as it is in the file.
warp::Mesh held_mesh(warp::Mesh mesh, const StageSide& side) {
  const cv::Size held = side.image.size();
  if (held == side.file_size) return mesh;
  for (cv::Point2d& vertex : mesh.vertices)
    vertex = {vertex.x * held.width / side.file_size.width, vertex.y * held.height / side.file_size.height};
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(held)});
  return mesh;
}

}  // namespace

const char* text_of(warp::MeshFoldKind kind) {
  constexpr std::array kTexts{"is not right of its left neighbour", "is not below its upper neighbour",
                              "lies across the column on its left", "lies across the column on its right",
                              "lies across the row above it",       "lies across the row below it"};
  return kTexts[static_cast<std::size_t>(kind)];
}

void require_unfolded(const warp::Mesh& mesh, const std::string& name, const std::string& place) {
  const std::vector<warp::MeshFold> folds = warp::find_folds(mesh);
  if (folds.empty()) return;
  const warp::MeshVertex at = folds.front().vertex;
  throw Error(ErrorCode::kBadInput, fmt::format("{}/{}", place, mesh.index(at.column, at.row)),
              fmt::format("the {} mesh folds over: the vertex in column {}, row {} {}{}{}", name, at.column, at.row,
                          text_of(folds.front().kind),
                          folds.size() > 1 ? fmt::format(" ({} vertices in all)", folds.size()) : "", kAllow));
}

MeshPasses passes_of(const MeshPair& pair, SideName side, warp::PassOrder order) {
  MeshPasses worst{order, 0, 0, 0};
  for (const double t : kMeshMoments) {
    const warp::MeshWarp warp(pair.file(side), between(pair, t), {warp::MeshSpline::kLinear, order});
    const std::size_t folds = warp::find_folds(warp.intermediate(order)).size();
    const double area_lost = warp.area_lost(order);
    if (std::tie(folds, area_lost) > std::tie(worst.folds, worst.area_lost)) worst = {order, folds, area_lost, t};
  }
  return worst;
}

MeshPasses choose_passes(const project::Project& project, const MeshPair& pair, SideName side) {
  if (project.warp.order != warp::PassOrder::kAuto) return passes_of(pair, side, project.warp.order);
  const MeshPasses rows = passes_of(pair, side, warp::PassOrder::kRowsFirst);
  const MeshPasses columns = passes_of(pair, side, warp::PassOrder::kColumnsFirst);
  return std::tie(columns.folds, columns.area_lost) < std::tie(rows.folds, rows.area_lost) ? columns : rows;
}

MeshMorpher::MeshMorpher(const project::Project& project, const Stage& stage, bool allow_folds)
    : project_(project),
      stage_(stage),
      pair_(mesh_pair(project, stage)),
      source_held_(held_mesh(pair_.source_file, stage.source)),
      destination_held_(held_mesh(pair_.destination_file, stage.destination)),
      allow_folds_(allow_folds) {
  if (!allow_folds) {
    const std::string file = project.file.string();
    require_unfolded(pair_.source_file, "source", file + ": /mesh/source");
    require_unfolded(pair_.destination_file, "destination", file + ": /mesh/destination");
  }
  source_passes_ = choose_passes(project, pair_, SideName::kSource);
  destination_passes_ = choose_passes(project, pair_, SideName::kDestination);
}

std::string MeshMorpher::description() const {
  const auto order = [](const MeshPasses& passes) {
    return fmt::format("{} first ({:.1f} % of the area lost between the passes)",
                       passes.order == warp::PassOrder::kRowsFirst ? "rows" : "columns", 100 * passes.area_lost);
  };
  return fmt::format("mesh of {} x {} vertices; source {}, destination {}", pair_.source_file.columns,
                     pair_.source_file.rows, order(source_passes_), order(destination_passes_));
}

std::size_t MeshMorpher::scratch_bytes() const {
  // The second warped picture and the intermediate image.
  const cv::Size source = stage_.source.image.size(), destination = stage_.destination.image.size();
  const std::size_t intermediate =
      static_cast<std::size_t>(std::max({stage_.size.width, source.width, destination.width})) *
      static_cast<std::size_t>(std::max({stage_.size.height, source.height, destination.height}));
  return (static_cast<std::size_t>(stage_.size.area()) + intermediate) * sizeof(warp::Pixel);
}

void MeshMorpher::require(double t) const {
  if (allow_folds_) return;
  const warp::Mesh mesh = between(pair_, t);
  const auto refuse = [&](const warp::MeshFold& fold, const std::string& what) {
    throw Error(ErrorCode::kBadInput, fmt::format("{}: /mesh", project_.file.string()),
                fmt::format("at t = {:g} {}: the vertex in column {}, row {} {}{}", t, what, fold.vertex.column,
                            fold.vertex.row, text_of(fold.kind), kAllow));
  };
  if (const auto folds = warp::find_folds(mesh); !folds.empty())
    refuse(folds.front(), "the in-between mesh folds over");
  for (const SideName side : {SideName::kSource, SideName::kDestination}) {
    const warp::PassOrder order = (side == SideName::kSource ? source_passes_ : destination_passes_).order;
    const warp::Mesh intermediate =
        warp::MeshWarp(pair_.file(side), mesh, {warp::MeshSpline::kLinear, order}).intermediate(order);
    if (const auto folds = warp::find_folds(intermediate); !folds.empty())
      refuse(folds.front(), fmt::format("the {} turns too far for two passes, its intermediate mesh ({} first) folds "
                                        "over",
                                        name_of(side), order == warp::PassOrder::kRowsFirst ? "rows" : "columns"));
  }
}

warp::Image MeshMorpher::warped(SideName name, const warp::Mesh& to) const {
  const bool is_source = name == SideName::kSource;
  const warp::MeshWarp warp(is_source ? source_held_ : destination_held_, to,
                            {project_.warp.spline, (is_source ? source_passes_ : destination_passes_).order});
  const StageSide& side = stage_.side(name);
  return warp.apply(side.image, stage_.size, side.border);
}

void MeshMorpher::mix(warp::Image& source, const warp::Image& destination, const warp::Mesh& mesh,
                      std::span<const double> dissolve) const {
  const bool local = std::any_of(dissolve.begin(), dissolve.end(), [&](double v) { return v != dissolve.front(); });
  const auto whole = static_cast<float>(dissolve.front());
  const warp::MeshValues values(mesh, dissolve);
  const auto columns = static_cast<std::size_t>(source.cols);
  warp::for_rows(source.rows, [&](int begin, int end) {
    std::vector<float> alpha(local ? columns : 1, whole);
    for (int y = begin; y < end; ++y) {
      if (local) values.row(y, alpha);
      dissolve_row({source[y], columns}, {destination[y], columns}, alpha, project_.blend);
    }
  });
}

warp::Image MeshMorpher::frame(double t) const {
  require(t);
  const warp::Mesh mesh = between(pair_, t);
  const std::vector<double> dissolve = dissolves(pair_, t);
  const auto [least, most] = std::minmax_element(dissolve.begin(), dissolve.end());
  if (*least >= 1) return warped(SideName::kDestination, mesh);
  warp::Image out = warped(SideName::kSource, mesh);
  if (*most > 0) mix(out, warped(SideName::kDestination, mesh), mesh, dissolve);
  return out;
}

warp::Map MeshMorpher::map(double t, SideName side) const {
  const warp::PassOrder order = (side == SideName::kSource ? source_passes_ : destination_passes_).order;
  return warp::MeshWarp(pair_.file(side), between(pair_, t), {project_.warp.spline, order}).map(stage_.size);
}

}  // namespace morphkit::render
