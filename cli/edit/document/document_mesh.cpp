// The mesh of a document.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "cli/edit/document/counterpart.h"
#include "cli/edit/document/document.h"
#include "cli/edit/document/groups.h"
#include "cli/edit/document/marks.h"
#include "morph/project/limits.h"
#include "morph/render/placement.h"
#include "warp/mesh/mesh.h"

namespace morphkit::edit {
namespace {

using project::MeshGroup;
using project::Project;

constexpr SideIndex kSides[] = {project::kSource, project::kDestination};

/// Default number of vertices of a new mesh, in each direction.
constexpr int kDefaultMesh = 5;

std::vector<cv::Point2d>& vertices_of(project::Mesh& mesh, SideIndex side) {
  return mesh.vertices[side];
}

std::set<std::string> groups_of(const std::optional<project::Mesh>& mesh) {
  std::set<std::string> ids;
  if (!mesh) return ids;
  for (const MeshGroup& group : mesh->groups) ids.insert(group.group);
  return ids;
}

bool allowed(int columns, int rows) {
  return std::min(columns, rows) >= 2 && std::max(columns, rows) <= project::kMaxMeshSize &&
         columns * rows <= project::kMaxMeshVertices;
}

void lay_mesh(Project& project, int columns, int rows) {
  const std::set<std::string> left = groups_of(project.mesh);
  project.mesh = project::Mesh{.columns = columns, .rows = rows, .vertices = {{}, {}}, .groups = {}};
  remove_unused_groups(project, left);
}

/// Rows are the columns of the transposed mesh: operations on either are written for columns.
void transpose(project::Mesh& mesh) {
  for (const SideIndex side : kSides) {
    std::vector<cv::Point2d>& vertices = vertices_of(mesh, side);
    vertices = warp::transposed({mesh.columns, mesh.rows, std::move(vertices)}).vertices;
  }
  for (MeshGroup& group : mesh.groups) {
    for (cv::Point& vertex : group.vertices) std::swap(vertex.x, vertex.y);
  }
  std::swap(mesh.columns, mesh.rows);
}

/// A new vertex between two of one group joins them.
void insert_into_groups(project::Mesh& mesh, int after) {
  for (MeshGroup& group : mesh.groups) {
    std::set<int> left, right;
    for (cv::Point& vertex : group.vertices) {
      if (vertex.x == after) left.insert(vertex.y);
      if (vertex.x == after + 1) right.insert(vertex.y);
      if (vertex.x > after) ++vertex.x;
    }
    for (const int row : left) {
      if (right.contains(row)) group.vertices.emplace_back(after + 1, row);
    }
  }
}

/// @pre both sides are spelled out.
void insert_column_into(project::Mesh& mesh, int after, double fraction) {
  for (const SideIndex side : kSides) {
    const auto& old = vertices_of(mesh, side);
    std::vector<cv::Point2d> vertices;
    vertices.reserve(old.size() + static_cast<std::size_t>(mesh.rows));
    for (std::size_t i = 0; i < old.size(); ++i) {
      vertices.push_back(old[i]);
      if (static_cast<int>(i) % mesh.columns != after) continue;
      vertices.push_back(render::lerp(old[i], old[i + 1], fraction));
    }
    vertices_of(mesh, side) = std::move(vertices);
  }
  insert_into_groups(mesh, after);
  ++mesh.columns;
}

void remove_column_from(project::Mesh& mesh, int column) {
  for (const SideIndex side : kSides) {
    int i = 0;
    std::erase_if(vertices_of(mesh, side), [&](const cv::Point2d&) { return i++ % mesh.columns == column; });
  }
  for (MeshGroup& group : mesh.groups) {
    std::erase_if(group.vertices, [&](cv::Point vertex) { return vertex.x == column; });
    for (cv::Point& vertex : group.vertices) vertex.x -= vertex.x > column ? 1 : 0;
  }
  std::erase_if(mesh.groups, [](const MeshGroup& group) { return group.vertices.empty(); });
  --mesh.columns;
}

/// Selected vertices as the mesh counts them after an edit. @param moved  new column or row of an old one, < 0: gone.
template <typename Moved>
std::vector<int> renumbered(const std::vector<int>& vertices, int columns, int new_columns, bool by_column,
                            const Moved& moved) {
  std::vector<int> result;
  result.reserve(vertices.size());
  for (const int vertex : vertices) {
    const int column = by_column ? moved(vertex % columns) : vertex % columns;
    const int row = by_column ? vertex / columns : moved(vertex / columns);
    if (column >= 0 && row >= 0) result.push_back(row * new_columns + column);
  }
  return result;
}

}  // namespace

void Document::set_method(project::MethodName method) {
  change([&](Project& project) {
    if (method == project::MethodName::kMesh && !project.mesh) lay_mesh(project, kDefaultMesh, kDefaultMesh);
    if (project::method_name_of(project) != method) project.warp.method = method;
  });
}

void Document::make_mesh(int columns, int rows) {
  columns = std::clamp(columns, 2, project::kMaxMeshSize);
  rows = std::clamp(rows, 2, std::min(project::kMaxMeshSize, project::kMaxMeshVertices / columns));
  change([&](Project& project) {
    lay_mesh(project, columns, rows);
    state_.selection.vertices.clear();
  });
}

std::vector<cv::Point2d> Document::mesh_vertices(SideIndex side) const {
  if (!has_mesh()) return {};
  const project::Mesh& mesh = *project().mesh;
  return vertices_on(picture_size(side), mesh.columns, mesh.rows, mesh.vertices[side]);
}

void Document::move_vertices(std::span<const int> vertices, SideIndex side, cv::Point2d by) {
  if (!has_mesh() || vertices.empty() || !finite(by)) return;
  const int columns = project().mesh->columns, rows = project().mesh->rows;
  const cv::Size size = picture_size(side);
  const std::vector<cv::Point2d> before = mesh_vertices(side);
  std::vector<cv::Point2d> after = before;
  for (const int vertex : vertices) {
    if (vertex < 0 || vertex >= columns * rows) continue;
    const int column = vertex % columns, row = vertex / columns;
    cv::Point2d& at = after[static_cast<std::size_t>(vertex)];
    if (column > 0 && column + 1 < columns) at.x = std::clamp(at.x + by.x, 0.0, static_cast<double>(size.width));
    if (row > 0 && row + 1 < rows) at.y = std::clamp(at.y + by.y, 0.0, static_cast<double>(size.height));
    at = rounded_off(at);
  }
  if (after == before) return;
  change([&](Project& project) { vertices_of(*project.mesh, side) = std::move(after); });
}

void Document::change_mesh(bool columns, const std::function<void(project::Mesh&)>& edit,
                           const std::function<int(int)>& moved) {
  change([&](Project& project) {
    const std::set<std::string> left = groups_of(project.mesh);
    const int old_columns = project.mesh->columns;
    for (const SideIndex side : kSides) vertices_of(*project.mesh, side) = mesh_vertices(side);
    if (!columns) transpose(*project.mesh);
    edit(*project.mesh);
    if (!columns) transpose(*project.mesh);
    remove_unused_groups(project, left);
    state_.selection.vertices = renumbered(selection().vertices, old_columns, project.mesh->columns, columns, moved);
  });
}

void Document::insert(bool column, int after, double fraction) {
  if (!has_mesh() || std::isnan(fraction)) return;
  const int columns = project().mesh->columns, rows = project().mesh->rows;
  if (after < 0 || after + 1 >= (column ? columns : rows) || !allowed(columns + column, rows + !column)) return;
  constexpr double kLeast = 1.0 / 64;  // apart from both neighbours
  fraction = std::clamp(fraction, kLeast, 1 - kLeast);
  change_mesh(
      column, [&](project::Mesh& mesh) { insert_column_into(mesh, after, fraction); },
      [&](int i) { return i > after ? i + 1 : i; });
}

bool Document::remove(bool column, int which) {
  if (!has_mesh()) return false;
  const int count = column ? project().mesh->columns : project().mesh->rows;
  if (which <= 0 || which + 1 >= count) return false;
  change_mesh(
      column, [&](project::Mesh& mesh) { remove_column_from(mesh, which); },
      [&](int i) { return i == which  ? -1
                          : i > which ? i - 1
                                      : i; });
  return true;
}

void Document::insert_column(int after, double fraction) {
  insert(true, after, fraction);
}

void Document::insert_row(int after, double fraction) {
  insert(false, after, fraction);
}

bool Document::remove_column(int column) {
  return remove(true, column);
}

bool Document::remove_row(int row) {
  return remove(false, row);
}

}  // namespace morphkit::edit
