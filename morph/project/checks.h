#pragma once
// Checks that look across the keys of a document. Internal to morph/project.

#include "morph/json/cursor.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// @param at  the feature, the mesh, the whole document in the text. @throws Error kBadInput.
void check(const json::Cursor& at, const Feature& feature);
void check(const json::Cursor& at, const Mesh& mesh);
void check_document(const json::Cursor& root, const Project& project);

}  // namespace morphkit::project
