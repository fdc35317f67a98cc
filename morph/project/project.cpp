#include "morph/project/project.h"

#include <algorithm>

namespace morphkit::project {
namespace {

template <typename T>
void fill(std::optional<T>& value, const std::optional<T>& fallback) {
  if (!value) value = fallback;
}

/// Fills what `nearer` leaves open.
void fall_back(Pull& nearer, const Pull& farther) {
  fill(nearer.a, farther.a);
  fill(nearer.b, farther.b);
  fill(nearer.p, farther.p);
  fill(nearer.scale, farther.scale);
  fill(nearer.between, farther.between);
  fill(nearer.turns, farther.turns);
}

void fall_back(Pace& nearer, const Pace& farther) {
  fill(nearer.shape, farther.shape);
  fill(nearer.dissolve, farther.dissolve);
}

const Pull kUsualPull{
    .a = 1, .b = 2, .p = 0, .scale = warp::LineScale::kAlong, .between = Between::kEndpoints, .turns = 0};
const Pace kUsualPace{.shape = motion::Timing{}, .dissolve = motion::Timing{}};

/// What `member` of the group says; nothing if there is no such group.
template <typename T>
T of_group(const Project& project, const std::string& group, T Group::*member) {
  if (group.empty()) return {};
  const auto found = std::ranges::find(project.groups, group, &Group::id);
  return found != project.groups.end() ? (*found).*member : T{};
}

template <typename T>
T resolved(T nearer, const T& farther) {
  fall_back(nearer, farther);
  return nearer;
}

}  // namespace

std::filesystem::path resolve(const Project& project, const std::filesystem::path& path) {
  // operator/ leaves an absolute path as it is.
  return project.file.parent_path() / path;
}

Pull effective_pull(const Project& project) {
  return resolved(project.pull, kUsualPull);
}

Pace effective_pace(const Project& project) {
  return resolved(project.pace, kUsualPace);
}

Pull effective_pull(const Project& project, const std::string& group) {
  return resolved(of_group(project, group, &Group::pull), effective_pull(project));
}

Pace effective_pace(const Project& project, const std::string& group) {
  return resolved(of_group(project, group, &Group::pace), effective_pace(project));
}

Pull effective_pull(const Project& project, const Feature& feature) {
  return resolved(feature.pull, effective_pull(project, feature.group));
}

Pace effective_pace(const Project& project, const Feature& feature) {
  return resolved(feature.pace, effective_pace(project, feature.group));
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
