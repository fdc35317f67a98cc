#include "morph/render/mesh_inbetween.h"

#include <algorithm>
#include <cmath>
#include <string>

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

warp::Mesh mesh_on(const project::Project& project, SideIndex side, cv::Size picture) {
  const std::vector<cv::Point2d>& vertices = project.mesh->vertices[side];
  const int columns = project.mesh->columns, rows = project.mesh->rows;
  const cv::Rect2d border({0, 0}, cv::Size2d(picture));
  if (vertices.empty()) return warp::uniform_mesh(columns, rows, border);
  warp::Mesh mesh{columns, rows, vertices};
  if (const auto off = warp::off_outline(mesh, border, kOutlineTolerancePx)) {
    const cv::Point2d at = mesh.at(off->column, off->row);
    throw Error(ErrorCode::kBadInput,
                fmt::format("{}: /mesh/{}/{}", project.file.string(), name_of(side), mesh.index(off->column, off->row)),
                fmt::format("the vertex in column {}, row {} is at ({:g}, {:g}) but belongs to the border of the "
                            "picture, which is {}x{}: border vertices lie on the border, corners at the corners",
                            off->column, off->row, at.x, at.y, picture.width, picture.height));
  }
  warp::snap_to_outline(mesh, border);
  return mesh;
}

warp::Mesh brought_to(warp::Mesh mesh, cv::Size from, cv::Size to) {
  if (from == to) return mesh;
  for (cv::Point2d& vertex : mesh.vertices)
    vertex = {vertex.x * to.width / from.width, vertex.y * to.height / from.height};
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(to)});
  return mesh;
}

MeshPair mesh_pair(const project::Project& project, const Stage& stage) {
  const project::Mesh& mesh = *project.mesh;
  MeshPair pair;
  pair.source_file = mesh_on(project, kSource, stage.sides[kSource].file_size);
  pair.destination_file = mesh_on(project, kDestination, stage.sides[kDestination].file_size);
  pair.source_held = brought_to(pair.source_file, stage.sides[kSource].file_size, stage.sides[kSource].image.size());
  pair.destination_held =
      brought_to(pair.destination_file, stage.sides[kDestination].file_size, stage.sides[kDestination].image.size());
  pair.source_canvas = on_canvas(pair.source_file, stage.sides[kSource].file);
  pair.destination_canvas = on_canvas(pair.destination_file, stage.sides[kDestination].file);
  pair.timings.push_back(project::effective_pace(project));
  pair.timing.assign(pair.source_file.vertices.size(), 0);
  for (const project::MeshGroup& group : mesh.groups) {
    for (const cv::Point& vertex : group.vertices)
      pair.timing[pair.source_file.index(vertex.x, vertex.y)] = pair.timings.size();
    pair.timings.push_back(project::effective_pace(project, group.group));
  }
  return pair;
}

warp::Mesh between(const MeshPair& pair, double t) {
  std::vector<double> progress;
  progress.reserve(pair.timings.size());
  for (const project::Pace& pace : pair.timings) progress.push_back(motion::progress(*pace.shape, t));
  warp::Mesh mesh = pair.source_canvas;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i] =
        lerp(pair.source_canvas.vertices[i], pair.destination_canvas.vertices[i], progress[pair.timing[i]]);
  const cv::Rect2d from = outline(pair.source_canvas), to = outline(pair.destination_canvas);
  const double whole = progress.front();
  warp::snap_to_outline(mesh, {lerp(from.tl(), to.tl(), whole), lerp(from.br(), to.br(), whole)});
  return mesh;
}

std::vector<double> dissolves(const MeshPair& pair, double t) {
  std::vector<double> progress;
  progress.reserve(pair.timings.size());
  for (const project::Pace& pace : pair.timings)
    progress.push_back(std::clamp(motion::progress(*pace.dissolve, t), 0.0, 1.0));
  std::vector<double> values;
  values.reserve(pair.timing.size());
  for (const std::size_t timing : pair.timing) values.push_back(progress[timing]);
  return values;
}

bool shows(const MeshPair& pair, SideIndex side, double t) {
  const std::vector<double> progress = dissolves(pair, t);
  return std::any_of(progress.begin(), progress.end(),
                     [&](double alpha) { return side == kSource ? alpha < 1 : alpha > 0; });
}

}  // namespace morphkit::render
