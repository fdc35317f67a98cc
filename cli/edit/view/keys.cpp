#include "cli/edit/view/keys.h"

#include <iterator>
#include <utility>

#include "base/words.h"

namespace morphkit::edit {
namespace {

using Rows = std::vector<KeyRow>;

/// The labels of a table: "dissolve, source, grid".
template <typename Table>
std::string words_of(const Table& table) {
  std::string words;
  for (const auto& row : table) words += (words.empty() ? "" : ", ") + lower(row.label);
  return words;
}

KeyRow tool_row() {
  KeyRow result{"Mark", "", "tools: " + words_of(kTools), {}};
  for (const ToolRow& row : kTools) {
    if (!result.keys.empty()) result.keys += ' ';
    result.keys += row.key;
    result.bindings.push_back({row.key, row.tool});
  }
  return result;
}

KeyRow switch_row(bool Switches::*flag) {
  const SwitchRow* row = kSwitches;
  while (row->toggle.flag != flag) ++row;
  return {"See", std::string(1, row->key), std::string(row->help), {{row->key, row->toggle}}};
}

Rows mark_rows() {
  const std::string_view section = "Mark";
  return {
      tool_row(),
      {section, "drag", "a line; a click places a point of the others", {}},
      {section,
       "Enter, double-click",
       "end a curve; click its first point to close it",
       {{kKeyEnter, Command::kEndCurve}}},
      {section, "Ctrl + drag", "draw, even over a mark that could be dragged", {}},
      {section, "Alt", "held: do not snap", {}},
      {section, "c", "mesh: add a column at the mouse", {{'c', Command::kAddColumnHere}}},
      {section, "r", "mesh: add a row at the mouse", {{'r', Command::kAddRowHere}}},
      {section, ",", "mesh: remove the column of the selected vertex", {{',', Command::kRemoveColumn}}},
      {section, ".", "mesh: remove its row", {{'.', Command::kRemoveRow}}},
  };
}

Rows change_rows() {
  const std::string_view section = "Select and change";
  return {
      {section, "click", "select; drag an end, or the whole", {}},
      {section, "Shift + click", "take into the selection, or out", {}},
      {section, "Shift + drag", "select what lies in a box", {}},
      {section, "a", "select all", {{'a', Command::kSelectAll}}},
      {section, "Tab", "select the next mark", {{kKeyTab, Command::kSelectNext}}},
      {section,
       "i j k l",
       "nudge up, left, down, right by a screen pixel",
       {{'i', Nudge{0, -1}}, {'j', Nudge{-1, 0}}, {'k', Nudge{0, 1}}, {'l', Nudge{1, 0}}}},
      {section, "e", "swap the ends, on both pictures", {{'e', Command::kSwapEnds}}},
      {section, "w", "swap the ends on the picture under the mouse", {{'w', Command::kSwapEndsHere}}},
      {section, "d", "duplicate", {{'d', Command::kDuplicate}}},
      {section,
       "Delete, Backspace, x",
       "delete",
       {{kKeyDelete, Command::kErase}, {kKeyBackspace, Command::kErase}, {'x', Command::kErase}}},
      {section, "n", "name", {{'n', Command::kName}}},
      {section, "g", "put into a group", {{'g', Command::kGroup}}},
      {section, "z", "undo; a curve's last click while it is drawn", {{'z', Command::kUndo}}},
      {section, "y", "redo", {{'y', Command::kRedo}}},
      {section, "Esc", "leave what is going on; select nothing", {{kKeyEscape, Command::kEscape}}},
  };
}

Rows see_rows() {
  const std::string_view section = "See";
  return {
      {section, "wheel", "zoom at the mouse", {}},
      {section, "right or middle drag", "move the picture; the result by any button", {}},
      {section, "0, double-click", "fit the pictures into their panes", {{'0', Command::kFit}}},
      {section, "Space", "play, pause", {{kKeySpace, Command::kPlay}}},
      {section, "- =", "slower, faster", {{'-', Command::kSlower}, {'=', Command::kFaster}}},
      {section, "[ ]", "a frame back, a frame on", {{'[', StepFrames{-1}}, {']', StepFrames{1}}}},
      {section, "Home, End", "source, destination", {{kKeyHome, GoTo{0}}, {kKeyEnd, GoTo{1}}}},
      {section, "v", "show the next: " + words_of(kShows), {{'v', Command::kNextShow}}},
      switch_row(&Switches::onion),
      switch_row(&Switches::folds),
      switch_row(&Switches::features),
      switch_row(&Switches::loupe),
      switch_row(&Switches::locked),
      switch_row(&Switches::snap),
  };
}

Rows file_rows() {
  const std::string_view section = "File";
  return {
      {section, "s", "save", {{'s', Command::kSave}}},
      {section, "q", "close", {{'q', Command::kClose}}},
      {section, "h, F1", "this help", {{'h', Command::kHelp}, {kKeyF1, Command::kHelp}}},
  };
}

}  // namespace

std::span<const KeyRow> key_rows() {
  static const Rows rows = [] {
    Rows all;
    for (Rows section : {mark_rows(), change_rows(), see_rows(), file_rows()})
      all.insert(all.end(), std::move_iterator(section.begin()), std::move_iterator(section.end()));
    return all;
  }();
  return rows;
}

std::optional<Action> action_of(int key) {
  for (const KeyRow& row : key_rows())
    for (const KeyBinding& binding : row.bindings)
      if (binding.key == key) return binding.action;
  return std::nullopt;
}

}  // namespace morphkit::edit
