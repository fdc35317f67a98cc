#include "morph/project/checks.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/words.h"

namespace morphkit::project {
namespace {

/// The place on one side that a message is about.
json::Cursor side_of(const json::Cursor& mark, SideIndex side) {
  return *mark.find(side == kSource ? "source" : "destination");
}

/// Refuses a mark whose first and last point coincide on one side only.
void require_joined_alike(const json::Cursor& mark, const Feature& feature, const char* message) {
  const auto joined = [&](SideIndex side) { return feature.places[side].front() == feature.places[side].back(); };
  if (joined(kSource) != joined(kDestination)) side_of(mark, joined(kSource) ? kSource : kDestination).fail(message);
}

void check_curve(const json::Cursor& mark, const Feature& feature, const Curve& curve) {
  for (const SideIndex side : {kSource, kDestination}) {
    const auto problem = motion::Curve::problem(curve.kind, feature.places[side], curve.closed);
    if (problem) side_of(mark, side).fail(*problem);
  }
  if (curve.closed) return;
  require_joined_alike(mark, feature,
                       "the curve ends where it starts on this side only; let both sides do so, or neither");
}

template <typename T>
void check_ids(const json::Cursor& root, const char* key, const std::vector<T>& list) {
  std::set<std::string_view> ids;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (ids.insert(list[i].id).second) continue;
    root.find(key)->item(i).find("id")->fail(
        fmt::format("the id {} occurs twice in {}; each needs its own", json::shown(list[i].id), key));
  }
}

/// The id of one of the groups, or a message with the nearest id.
void check_group(const json::Cursor& at, std::string_view group, const std::set<std::string_view>& known) {
  if (known.contains(group)) return;
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto meant = nearest(group, names);
  at.fail(fmt::format("no group has the id {}; {}", json::shown(group),
                      meant ? fmt::format("did you mean {}?", json::shown(*meant)) : "add it to \"groups\""));
}

void check_groups(const json::Cursor& root, const Project& project) {
  std::set<std::string_view> known;
  for (const Group& group : project.groups) known.insert(group.id);
  for (std::size_t i = 0; i < project.features.size(); ++i) {
    const std::string& group = project.features[i].group;
    if (!group.empty()) check_group(*root.find("features")->item(i).find("group"), group, known);
  }
  if (!project.mesh) return;
  for (std::size_t i = 0; i < project.mesh->groups.size(); ++i) {
    const json::Cursor at = *root.find("mesh")->find("groups")->item(i).find("group");
    check_group(at, project.mesh->groups[i].group, known);
  }
}

/// Checks that warp and mesh agree.
void check_method(const json::Cursor& root, const Project& project) {
  // The setting may come from elsewhere than this document (read_features_over).
  const auto place = [&](const char* key) {
    const auto warp = root.find("warp");
    const auto setting = warp ? warp->find(key) : std::nullopt;
    return setting ? *setting : root;
  };
  if (method_name_of(project) != MethodName::kMesh) return;
  if (!project.mesh) {
    place("method").fail(
        R"(the method "mesh" needs a mesh; add "mesh": {"size": [columns, rows], "source": ..., "destination": ...})");
  }
  if (project.warp.border == warp::Border::kMirror) {
    place("border").fail(R"(the method "mesh" cannot mirror; expected the border "auto", "transparent" or "clamp")");
  }
}

}  // namespace

void check(const json::Cursor& at, const Feature& feature) {
  const auto line = at.find("line"), point = at.find("point"), curve = at.find("curve");
  if (line.has_value() + point.has_value() + curve.has_value() != 1) {
    at.fail("a feature is exactly one of \"line\", \"point\" and \"curve\"");
  }
  if (curve) check_curve(*curve, feature, std::get<Curve>(feature.mark));
  if (line) {
    require_joined_alike(*line, feature,
                         "both ends lie at the same place on this side only; move one of them, or make it a \"point\"");
  }
}

void check(const json::Cursor& at, const Mesh& mesh) {
  const auto count = static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows);
  std::vector<const std::string*> owner(mesh.groups.empty() ? 0 : count, nullptr);
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < mesh.groups.size(); ++i) {
    const MeshGroup& group = mesh.groups[i];
    const json::Cursor item = at.find("groups")->item(i);
    if (!seen.insert(group.group).second) {
      item.find("group")->fail(
          fmt::format("the group {} has vertices already; list them all together", json::shown(group.group)));
    }
    const json::Cursor vertices = *item.find("vertices");
    vertices.expect_array(0, count, fmt::format("an array of at most {} vertices [column, row]", count));
    for (std::size_t k = 0; k < group.vertices.size(); ++k) {
      const int column = vertices.item(k).item(0).integer(0, mesh.columns - 1);
      const int row = vertices.item(k).item(1).integer(0, mesh.rows - 1);
      const std::string*& owned = owner[static_cast<std::size_t>(row) * static_cast<std::size_t>(mesh.columns) +
                                        static_cast<std::size_t>(column)];
      if (owned) {
        vertices.item(k).fail(fmt::format("the vertex [{}, {}] is in the group {} already; a vertex is in one at most",
                                          column, row, json::shown(*owned)));
      }
      owned = &group.group;
    }
  }
}

void check_document(const json::Cursor& root, const Project& project) {
  check_ids(root, "groups", project.groups);
  check_ids(root, "features", project.features);
  check_groups(root, project);
  check_method(root, project);
}

}  // namespace morphkit::project
