#pragma once
// Groups that come and go with what belongs to them. Internal to cli/edit.

#include <set>
#include <string>

#include "morph/project/project.h"

namespace morphkit::edit {

/// Makes the group if the project has none of that id; not for an empty id.
void add_group(project::Project& project, const std::string& id);

/// Removes those of `left`, from which something was taken away, that are empty now and set nothing. Parts of a mesh
/// belong to a group like features do.
void drop_idle_groups(project::Project& project, const std::set<std::string>& left);

}  // namespace morphkit::edit
