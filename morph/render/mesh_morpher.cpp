#include "morph/render/mesh_morpher.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/parallel.h"
#include "morph/render/dissolve.h"

namespace morphkit::render {
namespace {

/// The colour of the edge goes on only if both pictures fill the canvas: if one does not, the outline in between does
/// not either.
warp::Border border_of(const project::Project& project, const Stage& stage) {
  if (project.warp.border) return *project.warp.border;
  return stage.source.border == warp::Border::kClamp ? stage.destination.border : stage.source.border;
}

}  // namespace

const char* text_of(warp::MeshFoldKind kind) {
  constexpr std::array kTexts{"is not right of its left neighbour", "is not below its upper neighbour",
                              "lies across the column on its left", "lies across the column on its right",
                              "lies across the row above it",       "lies across the row below it"};
  return kTexts[static_cast<std::size_t>(kind)];
}

const char* text_of(warp::PassOrder order) {
  return order == warp::PassOrder::kRowsFirst ? "rows first" : "columns first";
}

void require_unfolded(const warp::Mesh& mesh, const std::string& what, const std::string& place) {
  const std::vector<warp::MeshFold> folds = warp::find_folds(mesh);
  if (folds.empty()) return;
  const warp::MeshVertex at = folds.front().vertex;
  throw Error(ErrorCode::kBadInput,
              place.ends_with('/') ? place + std::to_string(mesh.index(at.column, at.row)) : place,
              fmt::format("{}: the vertex in column {}, row {} {}{}; move it back into order, or render what can be "
                          "rendered with --allow-folds",
                          what, at.column, at.row, text_of(folds.front().kind),
                          folds.size() > 1 ? fmt::format(" ({} vertices in all)", folds.size()) : ""));
}

MeshPasses passes_of(const MeshPair& pair, SideIndex side, warp::PassOrder order) {
  MeshPasses worst{order, 0, 0, 0};
  for (const double t : kMoments) {
    if (!shows(pair, side, t)) continue;
    const warp::Mesh to = between(pair, t);
    const std::size_t folds = warp::find_folds(warp::intermediate_mesh(pair.held(side), to, order)).size();
    const double area_lost = warp::area_lost(pair.held(side), to, order);
    if (std::tie(folds, area_lost) > std::tie(worst.folds, worst.area_lost)) worst = {order, folds, area_lost, t};
  }
  return worst;
}

MeshPasses choose_passes(const project::Project& project, const MeshPair& pair, SideIndex side) {
  if (project.warp.mesh.order != warp::PassOrder::kAuto) return passes_of(pair, side, project.warp.mesh.order);
  const MeshPasses rows = passes_of(pair, side, warp::PassOrder::kRowsFirst);
  const MeshPasses columns = passes_of(pair, side, warp::PassOrder::kColumnsFirst);
  return std::tie(columns.folds, columns.area_lost) < std::tie(rows.folds, rows.area_lost) ? columns : rows;
}

MeshMorpher::MeshMorpher(const project::Project& project, const Stage& stage, bool allow_folds)
    : project_(project),
      stage_(stage),
      pair_(mesh_pair(project, stage)),
      source_passes_(choose_passes(project, pair_, kSource)),
      destination_passes_(choose_passes(project, pair_, kDestination)),
      border_(border_of(project, stage)),
      allow_folds_(allow_folds) {
  if (allow_folds) return;
  const std::string file = project.file.string();
  require_unfolded(pair_.source_file, "the source mesh folds over", file + ": /mesh/source/");
  require_unfolded(pair_.destination_file, "the destination mesh folds over", file + ": /mesh/destination/");
}

std::string MeshMorpher::description() const {
  const auto told = [](const MeshPasses& passes) {
    return fmt::format("{} ({:.1f} % of the area lost between the passes)", text_of(passes.order),
                       100 * passes.area_lost);
  };
  return fmt::format("mesh of {} x {} vertices; source {}, destination {}", pair_.source_file.columns,
                     pair_.source_file.rows, told(source_passes_), told(destination_passes_));
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
  const std::string place = project_.file.string() + ": /mesh";
  require_unfolded(mesh, fmt::format("at t = {:g} the in-between mesh folds over", t), place);
  for (const SideIndex side : {kSource, kDestination}) {
    if (!shows(side, t)) continue;
    require_unfolded(warp::intermediate_mesh(pair_.held(side), mesh, order(side)),
                     fmt::format("at t = {:g} the {} turns too far for two passes, {}, and folds between them", t,
                                 name_of(side), text_of(order(side))),
                     place);
  }
}

warp::Image MeshMorpher::warped(SideIndex side, const warp::Mesh& to) const {
  const warp::MeshWarp warp(pair_.held(side), to, {project_.warp.mesh.spline, order(side)});
  return warp.apply(stage_.side(side).image, stage_.size, border_);
}

void MeshMorpher::mix(warp::Image& source, const warp::Image& destination, const warp::Mesh& mesh,
                      std::span<const double> dissolve) const {
  const bool local = std::any_of(dissolve.begin(), dissolve.end(), [&](double v) { return v != dissolve.front(); });
  const auto whole = static_cast<float>(dissolve.front());
  const warp::MeshValues values(mesh, dissolve);
  const auto columns = static_cast<std::size_t>(source.cols);
  for_rows(source.rows, [&](int begin, int end) {
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
  if (*least >= 1) return warped(kDestination, mesh);
  warp::Image out = warped(kSource, mesh);
  if (*most > 0) mix(out, warped(kDestination, mesh), mesh, dissolve);
  return out;
}

warp::Map MeshMorpher::map(double t, SideIndex side) const {
  return warp::MeshWarp(pair_.file(side), between(pair_, t), {project_.warp.mesh.spline, order(side)}).map(stage_.size);
}

}  // namespace morphkit::render
