#pragma once
// "Did you mean ...?"

#include <optional>
#include <string>
#include <vector>

namespace morphkit::cli {

/// The candidate with the fewest edits (insert, delete, replace, swap neighbours) from `word`; nothing if even that
/// needs more than a third of the word's length (at least one edit is forgiven). The first of equals wins.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace morphkit::cli
