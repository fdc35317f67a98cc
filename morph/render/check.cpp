#include "morph/render/check.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "morph/render/line_check.h"
#include "morph/render/mesh_check.h"
#include "warp/analysis.h"

namespace morphkit::render {
namespace {

/// Puts the features or vertices nearest to the worst fold into the finding, and names them for the message.
std::string name_nearest(const Renderer& renderer, project::Time time, Finding& fold) {
  if (project::method_name_of(renderer.project()) == project::MethodName::kMesh) {
    fold.vertices = {nearest_vertex(renderer, fold.position, time)};
    return fmt::format(" near the vertex in column {}, row {}", fold.vertices[0].x, fold.vertices[0].y);
  }
  fold.features = nearest_features(renderer, fold.position, time);
  return fold.features.empty() ? "" : fmt::format(" near \"{}\"", fmt::join(fold.features, "\", \""));
}

void find_map_folds(const Renderer& renderer, SideIndex side, std::vector<Finding>& findings) {
  Finding worst;
  worst.kind = Finding::Kind::kFold;
  worst.where = name_of(side);
  for (const double t : kMoments) {
    const project::Time time = renderer.clock().at(t);
    if (!renderer.shows(side, time)) continue;
    const std::vector<warp::FoldRegion> regions = warp::find_folds(renderer.map(time, side));
    std::int64_t area_px = 0;
    for (const warp::FoldRegion& region : regions) area_px += region.area_px;
    if (area_px <= worst.area_px) continue;
    worst.t = t;
    worst.area_px = area_px;
    worst.count = static_cast<int>(regions.size());
    worst.position = regions.front().centroid;
  }
  if (worst.area_px == 0) return;
  worst.message = fmt::format("the {} folds over in {} {} ({} px at t = {:g}), the largest at ({:.0f}, {:.0f})",
                              worst.where, worst.count, worst.count == 1 ? "place" : "places", worst.area_px, worst.t,
                              worst.position.x, worst.position.y);
  worst.message += name_nearest(renderer, renderer.clock().at(worst.t), worst);
  findings.push_back(std::move(worst));
}

}  // namespace

const char* name_of(Finding::Kind kind) {
  constexpr std::array kNames{"crossing", "twins",     "outside-image", "outside-canvas",
                              "fold",     "mesh-fold", "bottleneck"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Finding> check(const Renderer& renderer) {
  std::vector<Finding> findings;
  const bool by_mesh = project::method_name_of(renderer.project()) == project::MethodName::kMesh;
  if (by_mesh)
    check_mesh(renderer, findings);
  else
    check_lines(renderer, findings);
  // Two passes along curves that keep their order cannot fold: there checking the vertices is enough.
  if (by_mesh && renderer.project().warp.mesh.spline != warp::MeshSpline::kCatmullRom) return findings;
  find_map_folds(renderer, kSource, findings);
  find_map_folds(renderer, kDestination, findings);
  return findings;
}

}  // namespace morphkit::render
