#include "morph/project/project.h"

#include <algorithm>

#include "morph/project/describe.h"
#include "morph/project/form_values.h"

namespace morphkit::project {
namespace {

/// The group's `member`; nothing if there is no such group.
template <typename T>
T of_group(const Project& project, const std::string& group, T Group::*member) {
  if (group.empty()) return {};
  const auto found = std::ranges::find(project.groups, group, &Group::id);
  return found != project.groups.end() ? (*found).*member : T{};
}

}  // namespace

std::filesystem::path resolve(const Project& project, const std::filesystem::path& path) {
  // operator/ leaves an absolute path as it is.
  return project.file.parent_path() / path;
}

Pull effective_pull(const Project& project) {
  return with_defaults(project.pull);
}

Pace effective_pace(const Project& project) {
  return with_defaults(project.pace);
}

Pull effective_pull(const Project& project, const std::string& group) {
  return inherited(of_group(project, group, &Group::pull), effective_pull(project));
}

Pace effective_pace(const Project& project, const std::string& group) {
  return inherited(of_group(project, group, &Group::pace), effective_pace(project));
}

Pull effective_pull(const Project& project, const Feature& feature) {
  return inherited(feature.pull, effective_pull(project, feature.group));
}

Pace effective_pace(const Project& project, const Feature& feature) {
  return inherited(feature.pace, effective_pace(project, feature.group));
}

bool same_document(const Project& a, const Project& b) {
  // A new member of Project does not compile here until it is compared or left out on purpose.
  const auto& [pictures, features, groups, mesh, warp, pull, pace, blend, output, file, original] = a;
  static_cast<void>(file);
  static_cast<void>(original);
  return pictures == b.pictures && features == b.features && groups == b.groups && mesh == b.mesh && warp == b.warp &&
         pull == b.pull && pace == b.pace && blend == b.blend && output == b.output;
}

}  // namespace morphkit::project
