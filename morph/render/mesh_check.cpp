#include "morph/render/mesh_check.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

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
                                std::string_view(where) == kInBetween ? "" : "in the ", where, first.column, first.row,
                                finding.position.x, finding.position.y, text_of(folds.front().kind));
  if (folds.size() > 1) finding.message += fmt::format(", and {} more are out of order", folds.size() - 1);
  return finding;
}

}  // namespace

std::vector<Finding> mesh_folds(const std::vector<MeshSide>& sides, const warp::Mesh& between, double t) {
  std::vector<Finding> findings;
  const auto look_at = [&](const warp::Mesh& mesh, const char* where, double when) {
    const std::vector<warp::MeshFold> folds = warp::find_folds(mesh);
    if (!folds.empty()) findings.push_back(fold_finding(mesh, folds, where, when));
  };
  for (SideIndex side = 0; side < sides.size(); ++side)
    look_at(sides[side].file, name_of(side), end_of(side, sides.size()));
  // A mesh that folds on a picture also does on the way.
  if (findings.empty()) look_at(between, kInBetween, t);
  return findings;
}

std::optional<Finding> bottleneck(SideIndex side, const MeshPasses& passes) {
  if (passes.folds == 0 && passes.area_lost < kVisibleLoss) return std::nullopt;
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
  return finding;
}

cv::Point nearest_vertex(const warp::Mesh& mesh, cv::Point2d position) {
  const auto distance = [&](cv::Point2d vertex) { return (vertex - position).dot(vertex - position); };
  const auto nearest = std::ranges::min_element(mesh.vertices, {}, distance);
  const int index = static_cast<int>(nearest - mesh.vertices.begin());
  return {index % mesh.columns, index / mesh.columns};
}

}  // namespace morphkit::render
