#include "morph/render/mesh_inbetween.h"

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit::render {
namespace {

cv::Rect2d outline(const warp::Mesh& mesh) {
  return {mesh.vertices.front(), mesh.vertices.back()};
}

warp::Mesh on_canvas(warp::Mesh mesh, const Placement& placement) {
  for (cv::Point2d& vertex : mesh.vertices) vertex = placement.to_canvas(vertex);
  return mesh;
}

}  // namespace

warp::Mesh mesh_on(const project::MomentMesh& mesh, SideIndex side, cv::Size picture,
                   const std::filesystem::path& project_file) {
  const project::Points& vertices = mesh.vertices[side];
  const cv::Rect2d border({0, 0}, cv::Size2d(picture));
  if (vertices.empty()) return warp::uniform_mesh(mesh.columns, mesh.rows, border);
  warp::Mesh result{mesh.columns, mesh.rows, vertices};
  if (const auto off = warp::off_outline(result, border, kOutlineTolerancePx)) {
    const cv::Point2d at = result.at(off->column, off->row);
    throw Error(
        ErrorKind::kBadInput,
        fmt::format("{}: /mesh/{}/{}", project_file.string(), name_of(side), result.index(off->column, off->row)),
        fmt::format("the vertex in column {}, row {} is at ({:g}, {:g}) but belongs to the border of the "
                    "picture, which is {}x{}: border vertices lie on the border, corners at the corners",
                    off->column, off->row, at.x, at.y, picture.width, picture.height));
  }
  warp::snap_to_outline(result, border);
  return result;
}

warp::Mesh scaled_to(warp::Mesh mesh, cv::Size from, cv::Size to) {
  if (from == to) return mesh;
  for (cv::Point2d& vertex : mesh.vertices)
    vertex = {vertex.x * to.width / from.width, vertex.y * to.height / from.height};
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(to)});
  return mesh;
}

std::vector<MeshSide> mesh_sides(const project::MomentMesh& mesh, const Stage& stage,
                                 const std::filesystem::path& project_file) {
  std::vector<MeshSide> sides;
  for (SideIndex side = 0; side < stage.sides.size(); ++side) {
    const StageSide& picture = stage.sides[side];
    const warp::Mesh file = mesh_on(mesh, side, picture.file_size, project_file);
    sides.push_back({file, scaled_to(file, picture.file_size, picture.image.size()), on_canvas(file, picture.file)});
  }
  return sides;
}

warp::Mesh between(const std::vector<MeshSide>& sides, const project::Moment& moment) {
  const auto mean_of = [&](const project::Weights& weights, const auto& position_of) {
    return mean(weights.shape, [&](SideIndex side) { return position_of(sides[side].canvas); });
  };
  const std::vector<std::size_t>& group = moment.mesh->group;
  warp::Mesh mesh = sides.front().canvas;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i] = mean_of(moment.mesh_weights[group[i]], [&](const warp::Mesh& side) { return side.vertices[i]; });
  const project::Weights& whole = moment.mesh_weights.front();
  warp::snap_to_outline(mesh, {mean_of(whole, [](const warp::Mesh& side) { return outline(side).tl(); }),
                               mean_of(whole, [](const warp::Mesh& side) { return outline(side).br(); })});
  return mesh;
}

std::vector<double> dissolves(const project::Moment& moment, SideIndex side) {
  std::vector<double> values;
  values.reserve(moment.mesh->group.size());
  for (const std::size_t group : moment.mesh->group) values.push_back(moment.mesh_weights[group].dissolve[side]);
  return values;
}

}  // namespace morphkit::render
