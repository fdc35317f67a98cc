#pragma once
// Every key and gesture as the help overlay and docs/edit.md show it.

#include <span>
#include <string_view>

namespace morphkit::edit {

struct HelpLine {
  std::string_view section;  ///< "Mark", "Select and change", "See", "File"
  std::string_view keys;     ///< "drag", "Shift + drag", "z", "Space"
  std::string_view text;     ///< what it does, a few words
};

/// In the order of the help overlay; sections lie together.
std::span<const HelpLine> help_lines();

}  // namespace morphkit::edit
