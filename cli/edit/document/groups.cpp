#include "cli/edit/document/groups.h"

#include <algorithm>

namespace morphkit::edit {

using project::Group;
using project::Project;

void add_group(Project& project, const std::string& id) {
  if (id.empty() || std::ranges::find(project.groups, id, &Group::id) != project.groups.end()) return;
  project.groups.push_back({id, {}, {}});
}

void remove_unused_groups(Project& project, const std::set<std::string>& left) {
  std::set<std::string_view> used;
  for (const project::Feature& feature : project.features) used.insert(feature.group);
  if (project.mesh) {
    for (const project::MeshGroup& group : project.mesh->groups) used.insert(group.group);
  }
  std::erase_if(project.groups, [&](const Group& group) {
    return left.contains(group.id) && !used.contains(group.id) && group.pull == project::Pull{} &&
           group.pace == project::Pace{};
  });
}

}  // namespace morphkit::edit
