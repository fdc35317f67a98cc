#pragma once
// Groups are made and removed together with their members. Internal to cli/edit.

#include <set>
#include <string>

#include "morph/project/project.h"

namespace morphkit::edit {

/// Makes the group if the project has none with that id; not for an empty id.
void add_group(project::Project& project, const std::string& id);

/// Removes the groups in `left` (groups that lost members) that are empty now and have no settings. Parts of a mesh are
/// members like features.
void remove_unused_groups(project::Project& project, const std::set<std::string>& left);

}  // namespace morphkit::edit
