#pragma once
// From a JSON tree to the document's values, checked. Internal to morph/project.

#include "morph/json/cursor.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// @throws Error kBadInput.
Project read_project(const json::Document& document);

/// Replaces features, mesh and groups of `project` by those of the document, and the settings of warp and transition
/// where the document has them. @throws Error kBadInput; `project` is then unchanged.
void read_features_over(Project& project, const json::Document& document);

}  // namespace morphkit::project
