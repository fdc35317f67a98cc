#pragma once
// The table of keys. It drives the keyboard, the help overlay and the test of docs/edit.md.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/edit/view/actions.h"

namespace morphkit::edit {

/// Keys as highgui's waitKeyEx gives them: letters in lower case, and these.
enum Key : int {
  kKeyBackspace = 8,
  kKeyTab = 9,
  kKeyEnter = 13,
  kKeyEscape = 27,
  kKeySpace = 32,
  kKeyHome = 65360,
  kKeyEnd = 65367,
  kKeyF1 = 65470,
  kKeyShift = 65505,
  kKeyDelete = 65535
};

struct KeyBinding {
  int key;
  Action action;
};

/// A line of the help. Lines about the mouse have no bindings.
struct KeyRow {
  std::string_view section;  ///< "Mark", "Select and change", "See", "File"
  std::string keys;          ///< "drag", "Shift + drag", "z", "Space"
  std::string text;          ///< what it does, a few words
  std::vector<KeyBinding> bindings;
};

/// In the order of the help overlay. The rows of a section lie together.
std::span<const KeyRow> key_rows();

/// What a key does, or nothing.
std::optional<Action> action_of(int key);

}  // namespace morphkit::edit
