#pragma once
// A changed document laid over the text that it came from. Internal to morph/project.

#include "morph/json/cursor.h"

namespace morphkit::project {

/// The tree to write: the values of `full`, in the order, spelling and selection of `original`, plus what `minimal`
/// has and `original` lacks.
/// @param original  a valid, located document; must outlive the result, which imitates its spacing.
/// @param full      with all defaults, @param minimal without.
json::Node merge(const json::Document& original, const json::Node& full, const json::Node& minimal);

}  // namespace morphkit::project
