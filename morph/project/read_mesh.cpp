#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

#include "morph/project/limits.h"
#include "morph/project/read_parts.h"

namespace morphkit::project {
namespace {

using json::Kind;

void read_size(const json::Cursor& at, Mesh& mesh) {
  at.expect_array(2, 2, "[columns, rows], the number of vertices in a row and in a column");
  mesh.columns = at.item(0).integer(2, kMaxMeshSize);
  mesh.rows = at.item(1).integer(2, kMaxMeshSize);
  if (mesh.columns * mesh.rows > kMaxMeshVertices) {
    at.fail(fmt::format("{} x {} is more than {} vertices", mesh.columns, mesh.rows, kMaxMeshVertices));
  }
}

std::size_t vertex_count(const Mesh& mesh) {
  return static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows);
}

/// The vertices of one side; none if they are evenly spaced.
std::vector<cv::Point2d> read_vertices(const json::Cursor& at, const Mesh& mesh) {
  if (at.is(Kind::kString) && at.string() == "uniform") return {};
  const std::string wanted =
      fmt::format("{} vertices [x, y] ({} columns x {} rows, row by row)", vertex_count(mesh), mesh.columns, mesh.rows);
  if (!at.is(Kind::kArray)) at.fail_expected(wanted + " or \"uniform\"");
  const auto count = vertex_count(mesh);
  return read_points(at, count, count, wanted);
}

cv::Point read_vertex(const json::Cursor& at, const Mesh& mesh) {
  at.expect_array(2, 2, "a vertex [column, row]");
  return {at.item(0).integer(0, mesh.columns - 1), at.item(1).integer(0, mesh.rows - 1)};
}

std::vector<MeshGroup> read_groups(const json::Cursor& at, const Mesh& mesh, const std::vector<Group>& groups) {
  at.expect_array(0, kMaxFeatures, fmt::format("an array of at most {} groups of vertices", kMaxFeatures));
  const std::set<std::string_view> known = group_ids(groups);
  const auto count = vertex_count(mesh);
  std::vector<const std::string*> owner(count, nullptr);
  std::set<std::string_view> seen;
  std::vector<MeshGroup> result;
  result.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const json::Cursor item = at.item(i);
    item.allow_keys({"group", "vertices"});
    const json::Cursor group = item.require("group", "the id of the group that times these vertices");
    const std::string& id = group.name("a group");
    check_group(group, id, known);
    if (!seen.insert(id).second) {
      group.fail(fmt::format("the group {} has vertices already; list them all together", json::shown(id)));
    }
    const json::Cursor vertices = item.require("vertices", "the vertices in this group, [[column, row], ...]");
    vertices.expect_array(0, count, fmt::format("an array of at most {} vertices [column, row]", count));
    MeshGroup entry{id, {}};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const cv::Point vertex = read_vertex(vertices.item(k), mesh);
      const std::string*& owned = owner[static_cast<std::size_t>(vertex.y) * static_cast<std::size_t>(mesh.columns) +
                                        static_cast<std::size_t>(vertex.x)];
      if (owned) {
        vertices.item(k).fail(fmt::format("the vertex [{}, {}] is in the group {} already; a vertex is in one at most",
                                          vertex.x, vertex.y, json::shown(*owned)));
      }
      owned = &id;
      entry.vertices.push_back(vertex);
    }
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

Mesh read_mesh(const json::Cursor& at, const std::vector<Group>& groups) {
  at.allow_keys({"size", "source", "destination", "groups"});
  Mesh mesh;
  read_size(at.require("size", "the number of vertices, [columns, rows]"), mesh);
  if (const auto source = at.find("source")) mesh.vertices[kSource] = read_vertices(*source, mesh);
  if (const auto destination = at.find("destination")) mesh.vertices[kDestination] = read_vertices(*destination, mesh);
  if (const auto list = at.find("groups")) mesh.groups = read_groups(*list, mesh, groups);
  return mesh;
}

}  // namespace morphkit::project
