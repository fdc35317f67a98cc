#pragma once
// Every key and gesture, in one table: the help overlay, the docs and the dispatcher read it.

#include <span>
#include <string_view>

namespace morphkit::edit {

struct HelpLine {
  std::string_view section;  ///< "Mark", "Select and change", "See", "Mesh", "Tune", "File"
  std::string_view keys;     ///< "drag", "shift + drag", "z", "space"
  std::string_view text;     ///< what it does, a few words
};

/// In the order of the help overlay; sections lie together.
std::span<const HelpLine> help_lines();

}  // namespace morphkit::edit
