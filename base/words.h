#pragma once
// Words that people type: letter case, and "did you mean ...?".

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace morphkit {

/// `text` with A-Z as a-z. Other bytes stay.
std::string lower(std::string_view text);

/// The candidate that a person who typed `word` most likely meant: the one with the fewest edits (insert, delete,
/// replace, swap neighbours; Damerau 1964, optimal string alignment), in lower case. The first of equals wins. @pre
/// `candidates` are lower case. nullopt if it needs more edits than a third of the word's length (one edit is always
/// allowed).
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates);
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace morphkit
