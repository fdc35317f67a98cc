#pragma once
// From a JSON tree to the document's values, checked. Internal to morph/project.

#include "morph/project/cursor.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// @throws Error kBadInput.
Project read_project(const Document& document);

/// Replaces features, mesh and groups of `project` by those of the document, and the settings of warp and transition
/// where the document has them. @throws Error kBadInput; `project` is then unchanged.
void read_features_over(Project& project, const Document& document);

}  // namespace morphkit::project
