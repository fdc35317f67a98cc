#pragma once
// A changed document laid over the text that it came from.

#include "morph/json/cursor.h"

namespace morphkit::json {

/// The tree to write: the values of `full`, in the order, spelling and selection of `original`, plus what `minimal`
/// has and `original` lacks.
/// @param original  a valid, located document; must outlive the result, which imitates its spacing.
/// @param full      with all defaults, @param minimal without. Where it says so (Node::identity, Node::same), lists are
///                  merged by id and other spellings of the same value stay.
Node merge(const Document& original, const Node& full, const Node& minimal);

}  // namespace morphkit::json
