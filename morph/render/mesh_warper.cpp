#include "morph/render/mesh_warper.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit::render {
namespace {

/// The colour of the edge goes on only if both pictures fill the canvas: if one does not, the outline in between does
/// not either.
warp::Border border_of(const project::Project& project, const Stage& stage) {
  if (project.warp.border) return *project.warp.border;
  return std::ranges::all_of(stage.sides, [](const StageSide& side) { return side.border == warp::Border::kClamp; })
             ? warp::Border::kClamp
             : warp::Border::kTransparent;
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

MeshPasses choose_passes(warp::PassOrder asked, const MeshPair& pair, SideIndex side) {
  if (asked != warp::PassOrder::kAuto) return passes_of(pair, side, asked);
  const MeshPasses rows = passes_of(pair, side, warp::PassOrder::kRowsFirst);
  const MeshPasses columns = passes_of(pair, side, warp::PassOrder::kColumnsFirst);
  return std::tie(columns.folds, columns.area_lost) < std::tie(rows.folds, rows.area_lost) ? columns : rows;
}

MeshWarper::MeshWarper(const MeshPair& pair, std::span<const MeshPasses> passes, warp::MeshSpline spline, warp::Mesh to,
                       std::span<const double> values, warp::Border border, const Stage& stage)
    : Warper(stage, {std::ranges::min(values), std::ranges::max(values)}),
      pair_(pair),
      passes_(passes),
      spline_(spline),
      to_(std::move(to)),
      values_(to_, values),
      border_(border) {}

warp::MeshWarp MeshWarper::bend(SideIndex side, Pixels pixels) const {
  const warp::Mesh& from = pixels == Pixels::kHeld ? pair_.held(side) : pair_.file(side);
  return {from, to_, {spline_, passes_[side].order}};
}

void MeshWarper::positions(int top, std::span<warp::Map> maps, Pixels pixels, cv::Mat1f* dissolve) const {
  for (SideIndex side = 0; side < maps.size(); ++side) {
    const warp::MeshWarp warp = bend(side, pixels);
    for (int y = 0; y < maps[side].rows; ++y)
      for (int x = 0; x < maps[side].cols; ++x) {
        const cv::Point2d position = warp.source_of({x + 0.5, top + y + 0.5});
        maps[side](y, x) = {static_cast<float>(position.x), static_cast<float>(position.y)};
      }
  }
  if (dissolve == nullptr) return;
  for (int y = 0; y < dissolve->rows; ++y)
    dissolve_row(top + y, {(*dissolve)[y], static_cast<std::size_t>(dissolve->cols)});
}

warp::Map MeshWarper::map(SideIndex side, Pixels pixels) const {
  return bend(side, pixels).map(stage().size);
}

std::optional<warp::Image> MeshWarper::drawn(SideIndex side) const {
  return bend(side, Pixels::kHeld).apply(stage().sides[side].image, stage().size, border_);
}

void MeshWarper::dissolve_row(int y, std::span<float> out) const {
  values_.row(y, out);
}

MeshPlan::MeshPlan(const project::Project& project, const project::MeshMethod& method, const Stage& stage,
                   bool allow_folds)
    : project_(project),
      method_(method),
      stage_(stage),
      pair_(mesh_pair(project, stage)),
      border_(border_of(project, stage)),
      allow_folds_(allow_folds) {
  for (SideIndex side = 0; side < stage.sides.size(); ++side)
    passes_.push_back(choose_passes(method.order, pair_, side));
  if (allow_folds) return;
  for (SideIndex side = 0; side < stage.sides.size(); ++side) {
    const char* const name = name_of(side);
    require_unfolded(pair_.file(side), fmt::format("the {} mesh folds over", name),
                     fmt::format("{}: /mesh/{}/", project.file.string(), name));
  }
}

std::unique_ptr<Warper> MeshPlan::at(double t) const {
  return std::make_unique<MeshWarper>(pair_, passes_, method_.spline, between(pair_, t), dissolves(pair_, t), border_,
                                      stage_);
}

DissolveRange MeshPlan::dissolve(double t) const {
  const std::vector<double> values = dissolves(pair_, t);
  return {std::ranges::min(values), std::ranges::max(values)};
}

std::string MeshPlan::label() const {
  std::string text = fmt::format("mesh of {} x {} vertices", pair_.source_file.columns, pair_.source_file.rows);
  for (SideIndex side = 0; side < passes_.size(); ++side)
    text += fmt::format("{} {} {} ({:.1f} % of the area lost between the passes)", side == 0 ? ";" : ",", name_of(side),
                        text_of(passes_[side].order), 100 * passes_[side].area_lost);
  return text;
}

std::size_t MeshPlan::scratch_bytes() const {
  // The second warped picture and the intermediate image.
  cv::Size largest = stage_.size;
  for (const StageSide& side : stage_.sides)
    largest = {std::max(largest.width, side.image.cols), std::max(largest.height, side.image.rows)};
  const std::size_t intermediate = static_cast<std::size_t>(largest.width) * static_cast<std::size_t>(largest.height);
  return (static_cast<std::size_t>(stage_.size.area()) + intermediate) * sizeof(warp::Pixel);
}

void MeshPlan::require(double t) const {
  if (allow_folds_) return;
  const warp::Mesh mesh = between(pair_, t);
  const std::string place = project_.file.string() + ": /mesh";
  require_unfolded(mesh, fmt::format("at t = {:g} the in-between mesh folds over", t), place);
  for (SideIndex side = 0; side < passes_.size(); ++side) {
    if (!dissolve(t).shows(side)) continue;
    const warp::PassOrder order = passes_[side].order;
    require_unfolded(warp::intermediate_mesh(pair_.held(side), mesh, order),
                     fmt::format("at t = {:g} the {} turns too far for two passes, {}, and folds between them", t,
                                 name_of(side), text_of(order)),
                     place);
  }
}

}  // namespace morphkit::render
