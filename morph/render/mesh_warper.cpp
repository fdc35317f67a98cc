#include "morph/render/mesh_warper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "morph/render/fold_error.h"
#include "morph/render/mesh_check.h"

namespace morphkit::render {
namespace {

/// The edge colour continues only if both pictures fill the canvas: if one does not, the outline in between does
/// not either.
warp::Border border_of(const project::Project& project, const Stage& stage) {
  if (project.warp.border) return *project.warp.border;
  return std::ranges::all_of(stage.sides, [](const StageSide& side) { return side.border == warp::Border::kClamp; })
             ? warp::Border::kClamp
             : warp::Border::kTransparent;
}

/// Over the groups that have vertices.
std::vector<WeightRange> weights_of(const project::Moment& moment) {
  std::vector<bool> used(moment.mesh_weights.size(), false);
  for (const std::size_t group : moment.mesh->group) used[group] = true;
  std::vector<project::Weights> weights;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) weights.push_back(moment.mesh_weights[i]);
  return ranges_of(weights);
}

/// Weights of the corners a, b, c of a triangle at x, which add up to 1; nullopt for a triangle without area.
std::optional<std::array<double, 3>> barycentric(cv::Point2d a, cv::Point2d b, cv::Point2d c, cv::Point2d x) {
  const double area = (b - a).cross(c - a);
  if (area == 0) return std::nullopt;
  const double at_b = (x - a).cross(c - a) / area, at_c = (b - a).cross(x - a) / area;
  return std::array{1 - at_b - at_c, at_b, at_c};
}

/// Maps the triangle that contains x, or is nearest to x, to its partner.
std::optional<cv::Point2d> carried(const warp::Mesh& here, const warp::Mesh& there, cv::Point2d x) {
  double best = -std::numeric_limits<double>::infinity();
  std::optional<cv::Point2d> result;
  const auto look_at = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto weights = barycentric(here.vertices[a], here.vertices[b], here.vertices[c], x);
    if (!weights) return;
    const double inside = std::ranges::min(*weights);
    if (!(inside > best)) return;
    best = inside;
    const auto& [at_a, at_b, at_c] = *weights;
    result = at_a * there.vertices[a] + at_b * there.vertices[b] + at_c * there.vertices[c];
  };
  for (int row = 0; row + 1 < here.rows; ++row)
    for (int column = 0; column + 1 < here.columns; ++column) {
      const std::size_t corner = here.index(column, row), across = here.index(column + 1, row + 1);
      look_at(corner, here.index(column + 1, row), across);
      look_at(corner, across, here.index(column, row + 1));
    }
  return result && std::isfinite(result->x) && std::isfinite(result->y) ? result : std::nullopt;
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
  throw FoldError(place.ends_with('/') ? place + std::to_string(mesh.index(at.column, at.row)) : place,
                  fmt::format("{}: the vertex in column {}, row {} {}{}; move it back into order", what, at.column,
                              at.row, text_of(folds.front().kind),
                              folds.size() > 1 ? fmt::format(" ({} vertices in all)", folds.size()) : ""));
}

MeshPasses passes_at(const warp::Mesh& held, const warp::Mesh& to, warp::PassOrder order, double t) {
  return {order, warp::find_folds(warp::intermediate_mesh(held, to, order)).size(), warp::area_lost(held, to, order),
          t};
}

MeshPasses passes_of(std::span<const MeshMoment> moments, SideIndex side, warp::PassOrder order) {
  MeshPasses worst{order, 0, 0, 0};
  for (const MeshMoment& mesh : moments) {
    if (!weights_of(mesh.moment)[side].shows()) continue;
    const MeshPasses passes =
        passes_at((*mesh.sides)[side].held, between(*mesh.sides, mesh.moment), order, mesh.moment.time.t);
    if (std::tie(passes.folds, passes.area_lost) > std::tie(worst.folds, worst.area_lost)) worst = passes;
  }
  return worst;
}

MeshPasses choose_passes(warp::PassOrder asked, std::span<const MeshMoment> moments, SideIndex side) {
  if (asked != warp::PassOrder::kAuto) return passes_of(moments, side, asked);
  const MeshPasses rows = passes_of(moments, side, warp::PassOrder::kRowsFirst);
  const MeshPasses columns = passes_of(moments, side, warp::PassOrder::kColumnsFirst);
  return std::tie(columns.folds, columns.area_lost) < std::tie(rows.folds, rows.area_lost) ? columns : rows;
}

MeshWarper::MeshWarper(const MeshMoment& mesh, const MeshPlan& plan, warp::Border border, const Stage& stage)
    : Warper(mesh.moment, stage, weights_of(mesh.moment)),
      sides_(mesh.sides),
      plan_(plan),
      spline_(std::get<project::MeshMethod>(mesh.moment.method).spline),
      to_(between(*mesh.sides, mesh.moment)),
      border_(border) {
  for (SideIndex side = 1; side < sides_->size(); ++side) values_.emplace_back(to_, dissolves(mesh.moment, side));
}

warp::MeshWarp MeshWarper::bend(SideIndex side, Pixels pixels) const {
  const MeshSide& from = (*sides_)[side];
  return {pixels == Pixels::kHeld ? from.held : from.file, to_, {spline_, plan_.passes()[side].order}};
}

void MeshWarper::positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const {
  for (SideIndex side = 0; side < maps.size(); ++side) {
    const warp::MeshWarp warp = bend(side, pixels);
    for (int y = 0; y < maps[side].rows; ++y)
      for (int x = 0; x < maps[side].cols; ++x) {
        const cv::Point2d position = warp.source_of({x + 0.5, top + y + 0.5});
        maps[side](y, x) = {static_cast<float>(position.x), static_cast<float>(position.y)};
      }
  }
  for (SideIndex i = 0; i < weights.size(); ++i)
    for (int y = 0; y < weights[i].rows; ++y)
      weight_row(i + 1, top + y, {weights[i][y], static_cast<std::size_t>(weights[i].cols)});
}

warp::Map MeshWarper::map(SideIndex side, Pixels pixels) const {
  return bend(side, pixels).map(stage().size);
}

std::optional<warp::Image> MeshWarper::drawn(SideIndex side) const {
  return bend(side, Pixels::kHeld).apply(stage().sides[side].image, stage().size, border_);
}

void MeshWarper::weight_row(SideIndex side, int y, std::span<float> out) const {
  values_[side - 1].row(y, out);
}

std::vector<Finding> MeshWarper::problems() const {
  std::vector<Finding> findings = mesh_folds(*sides_, to_, moment().time.t);
  for (SideIndex side = 0; side < sides_->size(); ++side) {
    if (!weights()[side].shows()) continue;
    const warp::PassOrder order = plan_.passes()[side].order;
    if (auto finding = bottleneck(side, passes_at((*sides_)[side].held, to_, order, moment().time.t)))
      findings.push_back(*std::move(finding));
  }
  // Two passes along curves that keep their order cannot fold: there checking the vertices is enough.
  if (spline_ == warp::MeshSpline::kCatmullRom) std::ranges::move(map_folds(), std::back_inserter(findings));
  return findings;
}

std::string MeshWarper::name_nearest(Finding& fold) const {
  fold.vertices = {nearest_vertex(to_, fold.position)};
  return fmt::format("the vertex in column {}, row {}", fold.vertices[0].x, fold.vertices[0].y);
}

std::optional<cv::Point2d> MeshWarper::carry(SideIndex from, SideIndex to, cv::Point2d point) const {
  const cv::Size size = stage().sides[from].file_size;
  const cv::Point2d inside(std::clamp(point.x, 0.0, static_cast<double>(size.width)),
                           std::clamp(point.y, 0.0, static_cast<double>(size.height)));
  return carried((*sides_)[from].file, (*sides_)[to].file, inside);
}

std::string MeshWarper::label() const {
  std::string text = fmt::format("mesh of {} x {} vertices", to_.columns, to_.rows);
  for (SideIndex side = 0; side < sides_->size(); ++side) {
    const MeshPasses& passes = plan_.passes()[side];
    text += fmt::format("{} {} {} ({:.1f} % of the area lost between the passes)", side == 0 ? ";" : ",", name_of(side),
                        text_of(passes.order), 100 * passes.area_lost);
  }
  return text;
}

MeshPlan::MeshPlan(const project::Project& project, const project::Evaluator& moments, const Stage& stage,
                   bool allow_folds)
    : file_(project.file),
      moments_(moments),
      stage_(stage),
      border_(border_of(project, stage)),
      allow_folds_(allow_folds) {
  first_ = mesh_at(moments.at(moments.clock().at(0)));
  if (allow_folds) return;
  for (SideIndex side = 0; side < stage.sides.size(); ++side) {
    const char* const name = name_of(side);
    require_unfolded((*first_.sides)[side].file, fmt::format("the {} mesh folds over", name),
                     fmt::format("{}: /mesh/{}/", file_.string(), name));
  }
}

MeshMoment MeshPlan::mesh_at(const project::Moment& moment) const {
  if (first_.sides && moment.mesh == first_.moment.mesh) return {moment, first_.sides};
  return {moment, std::make_shared<const std::vector<MeshSide>>(mesh_sides(*moment.mesh, stage_, file_))};
}

std::unique_ptr<Warper> MeshPlan::at(const project::Moment& moment) const {
  return std::make_unique<MeshWarper>(mesh_at(moment), *this, border_, stage_);
}

std::vector<WeightRange> MeshPlan::weights(const project::Moment& moment) const {
  return weights_of(moment);
}

const std::vector<MeshPasses>& MeshPlan::passes() const {
  std::call_once(chosen_, [&] {
    std::vector<MeshMoment> looked_at;
    for (const double t : kMoments) looked_at.push_back(mesh_at(moments_.at(moments_.clock().at(t))));
    const warp::PassOrder asked = std::get<project::MeshMethod>(first_.moment.method).order;
    for (SideIndex side = 0; side < stage_.sides.size(); ++side)
      passes_.push_back(choose_passes(asked, looked_at, side));
  });
  return passes_;
}

std::size_t MeshPlan::scratch_bytes() const {
  // The second warped picture and the intermediate image.
  cv::Size largest = stage_.size;
  for (const StageSide& side : stage_.sides)
    largest = {std::max(largest.width, side.image.cols), std::max(largest.height, side.image.rows)};
  const std::size_t intermediate = static_cast<std::size_t>(largest.width) * static_cast<std::size_t>(largest.height);
  return (static_cast<std::size_t>(stage_.size.area()) + intermediate) * sizeof(warp::Pixel);
}

void MeshPlan::require(const project::Moment& moment) const {
  if (allow_folds_) return;
  const MeshMoment at = mesh_at(moment);
  const warp::Mesh mesh = between(*at.sides, moment);
  const std::string place = file_.string() + ": /mesh";
  const double t = moment.time.t;
  require_unfolded(mesh, fmt::format("at t = {:g} the in-between mesh folds over", t), place);
  const std::vector<WeightRange> weights = weights_of(moment);
  for (SideIndex side = 0; side < weights.size(); ++side) {
    if (!weights[side].shows()) continue;
    const warp::PassOrder order = passes()[side].order;
    require_unfolded(warp::intermediate_mesh((*at.sides)[side].held, mesh, order),
                     fmt::format("at t = {:g} the {} turns too far for two passes, {}, and folds between them", t,
                                 name_of(side), text_of(order)),
                     place);
  }
}

}  // namespace morphkit::render
