#pragma once
// A changed document laid over the text that it came from.

#include <string>

#include "morph/json/cursor.h"

namespace morphkit::json {

/// The tree to write: the values of `full`, in the order, spelling and selection of `original`, plus what `minimal`
/// has and `original` lacks.
/// @param original  a valid document, located in `text`; must outlive the result, which imitates its spacing.
/// @param full      with all defaults, @param minimal without. Where it says so (Hints::identity, Hints::same), lists
///                  are merged by id and other spellings of the same value stay.
/// Flat arrays that have changed are taken apart in all three; what they say stays.
Node merge(Document& original, const std::string& text, Node& full, Node& minimal);

}  // namespace morphkit::json
