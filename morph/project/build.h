#pragma once
// From the document's values to a JSON tree. Internal to morph/project.

#include "morph/json/json.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// @param defaults  also writes what has a default value (but not what is inherited).
json::Node build(const Project& project, bool defaults);

}  // namespace morphkit::project
