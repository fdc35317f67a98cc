#include "morph/render/mesh_check.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "morph/render/mesh_warper.h"

namespace morphkit::render {
namespace {

Finding fold_finding(const warp::Mesh& mesh, const std::vector<warp::MeshFold>& folds, const char* where, double t) {
  const warp::MeshVertex first = folds.front().vertex;
  Finding finding;
  finding.kind = Finding::Kind::kMeshFold;
  finding.where = where;
  finding.position = mesh.at(first.column, first.row);
  finding.t = t;
  finding.count = static_cast<int>(folds.size());
  for (const warp::MeshFold& fold : folds) finding.vertices.emplace_back(fold.vertex.column, fold.vertex.row);
  finding.message = fmt::format("the mesh folds over {}{}: the vertex in column {}, row {} at ({:.0f}, {:.0f}) {}",
                                std::string_view(where) == "in between" ? "" : "in the ", where, first.column,
                                first.row, finding.position.x, finding.position.y, text_of(folds.front().kind));
  if (folds.size() > 1) finding.message += fmt::format(", and {} more are out of order", folds.size() - 1);
  return finding;
}

/// Reports a mesh that folds on either side; if neither does, the moment in between at which it folds most.
void find_mesh_folds(std::span<const MeshMoment> moments, std::vector<Finding>& findings) {
  const std::vector<MeshSide>& sides = *moments.front().sides;
  const std::size_t before = findings.size();
  for (SideIndex side = 0; side < sides.size(); ++side) {
    const std::vector<warp::MeshFold> folds = warp::find_folds(sides[side].file);
    if (!folds.empty())
      findings.push_back(fold_finding(sides[side].file, folds, name_of(side), static_cast<double>(side)));
  }
  if (findings.size() > before) return;
  std::size_t most = 0;
  std::optional<Finding> worst;
  for (const MeshMoment& mesh : moments) {
    const warp::Mesh in_between = between(*mesh.sides, mesh.moment);
    const std::vector<warp::MeshFold> folds = warp::find_folds(in_between);
    if (folds.size() <= most) continue;
    most = folds.size();
    worst = fold_finding(in_between, folds, "in between", mesh.moment.time.t);
  }
  if (worst) findings.push_back(*std::move(worst));
}

void find_bottleneck(std::span<const MeshMoment> moments, SideIndex side, std::vector<Finding>& findings) {
  const warp::PassOrder order = std::get<project::MeshMethod>(moments.front().moment.method).order;
  const MeshPasses passes = choose_passes(order, moments, side);
  if (passes.folds == 0 && passes.area_lost < kVisibleLoss) return;
  Finding finding;
  finding.kind = Finding::Kind::kBottleneck;
  finding.where = name_of(side);
  finding.t = passes.t;
  finding.count = static_cast<int>(passes.folds);
  finding.area_lost = passes.area_lost;
  const std::string what =
      passes.folds > 0 ? fmt::format("folds over at {} {}: two passes cannot show it", passes.folds,
                                     passes.folds == 1 ? "vertex" : "vertices")
                       : fmt::format("lacks {:.0f} % of the area: it loses detail there", 100 * passes.area_lost);
  finding.message = fmt::format("the {} turns so far at t = {:g} that its intermediate image ({}) {}", finding.where,
                                passes.t, text_of(passes.order), what);
  findings.push_back(std::move(finding));
}

MeshMoment mesh_at(const Renderer& renderer, project::Time time) {
  const project::Moment moment = renderer.moment(time);
  return {moment, std::make_shared<const std::vector<MeshSide>>(
                      mesh_sides(*moment.mesh, renderer.stage(), renderer.project().file))};
}

}  // namespace

void check_mesh(const Renderer& renderer, std::vector<Finding>& findings) {
  std::vector<MeshMoment> moments;
  for (const double t : kMoments) moments.push_back(mesh_at(renderer, renderer.clock().at(t)));
  find_mesh_folds(moments, findings);
  for (SideIndex side = 0; side < renderer.stage().sides.size(); ++side) find_bottleneck(moments, side, findings);
}

cv::Point nearest_vertex(const Renderer& renderer, cv::Point2d position, project::Time time) {
  const MeshMoment at = mesh_at(renderer, time);
  const warp::Mesh mesh = between(*at.sides, at.moment);
  const auto distance = [&](cv::Point2d vertex) { return (vertex - position).dot(vertex - position); };
  const auto nearest = std::min_element(mesh.vertices.begin(), mesh.vertices.end(),
                                        [&](cv::Point2d a, cv::Point2d b) { return distance(a) < distance(b); });
  const int index = static_cast<int>(nearest - mesh.vertices.begin());
  return {index % mesh.columns, index / mesh.columns};
}

}  // namespace morphkit::render
