#include "morph/render/mesh_check.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

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
void find_mesh_folds(const MeshPair& pair, std::vector<Finding>& findings) {
  const auto in_source = warp::find_folds(pair.source_file), in_destination = warp::find_folds(pair.destination_file);
  if (!in_source.empty()) findings.push_back(fold_finding(pair.source_file, in_source, "source", 0));
  if (!in_destination.empty())
    findings.push_back(fold_finding(pair.destination_file, in_destination, "destination", 1));
  if (!in_source.empty() || !in_destination.empty()) return;
  std::vector<warp::MeshFold> worst;
  double worst_t = 0;
  for (const double t : kMoments) {
    std::vector<warp::MeshFold> folds = warp::find_folds(between(pair, t));
    if (folds.size() <= worst.size()) continue;
    worst = std::move(folds);
    worst_t = t;
  }
  if (!worst.empty()) findings.push_back(fold_finding(between(pair, worst_t), worst, "in between", worst_t));
}

void find_bottleneck(const project::Project& project, const MeshPair& pair, SideIndex side,
                     std::vector<Finding>& findings) {
  const MeshPasses passes = choose_passes(project.warp.mesh.order, pair, side);
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

}  // namespace

void check_mesh(const Renderer& renderer, std::vector<Finding>& findings) {
  const MeshPair pair = mesh_pair(renderer.project(), renderer.stage());
  find_mesh_folds(pair, findings);
  find_bottleneck(renderer.project(), pair, kSource, findings);
  find_bottleneck(renderer.project(), pair, kDestination, findings);
}

cv::Point nearest_vertex(const Renderer& renderer, cv::Point2d position, double t) {
  const warp::Mesh mesh = between(mesh_pair(renderer.project(), renderer.stage()), t);
  const auto distance = [&](cv::Point2d vertex) { return (vertex - position).dot(vertex - position); };
  const auto nearest = std::min_element(mesh.vertices.begin(), mesh.vertices.end(),
                                        [&](cv::Point2d a, cv::Point2d b) { return distance(a) < distance(b); });
  const int index = static_cast<int>(nearest - mesh.vertices.begin());
  return {index % mesh.columns, index / mesh.columns};
}

}  // namespace morphkit::render
