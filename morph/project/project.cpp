#include "morph/project/project.h"

#include <algorithm>

namespace morphkit::project {
namespace {

/// Fills what `nearer` leaves open.
void fall_back(Influence& nearer, const Influence& farther) {
  const auto fill = [](auto& value, const auto& fallback) {
    if (!value) value = fallback;
  };
  fill(nearer.a, farther.a);
  fill(nearer.b, farther.b);
  fill(nearer.p, farther.p);
  fill(nearer.scale, farther.scale);
  fill(nearer.between, farther.between);
  fill(nearer.turns, farther.turns);
  fill(nearer.shape, farther.shape);
  fill(nearer.dissolve, farther.dissolve);
}

Influence defaults() {
  return {.a = 1,
          .b = 2,
          .p = 0,
          .scale = warp::LineScale::kAlong,
          .between = Between::kEndpoints,
          .turns = 0,
          .shape = motion::Timing{},
          .dissolve = motion::Timing{}};
}

}  // namespace

std::filesystem::path resolve(const Project& project, const std::filesystem::path& path) {
  // operator/ leaves an absolute path as it is.
  return project.file.parent_path() / path;
}

Influence effective(const Project& project) {
  Influence result = project.influence;
  fall_back(result, defaults());
  return result;
}

Influence effective(const Project& project, const std::string& group) {
  Influence result;
  if (!group.empty()) {
    const auto found = std::ranges::find(project.groups, group, &Group::id);
    if (found != project.groups.end()) result = found->influence;
  }
  fall_back(result, effective(project));
  return result;
}

Influence effective(const Project& project, const Feature& feature) {
  Influence result = feature.influence;
  fall_back(result, effective(project, feature.group));
  return result;
}

Method method_of(const Project& project) {
  const bool mesh_alone = project.mesh && project.features.empty();
  return project.warp.method.value_or(mesh_alone ? Method::kMesh : Method::kLines);
}

bool same_document(const Project& a, const Project& b) {
  return a.source == b.source && a.destination == b.destination && a.features == b.features && a.groups == b.groups &&
         a.mesh == b.mesh && a.warp == b.warp && a.influence == b.influence && a.blend == b.blend &&
         a.output == b.output;
}

}  // namespace morphkit::project
