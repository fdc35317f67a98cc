#pragma once
// Everything that a key or a widget can do, as values; and the tables of tools, views of the result and switches.
// Layout, keys, help and docs read these tables. To add a tool: its enumerator and row here, its class in hand/.

#include <string_view>
#include <variant>

#include "cli/edit/document/document.h"

namespace morphkit::edit {

enum class ToolId { kSelect, kLine, kPoint, kCurve, kMesh };

/// What a tool selects and drags.
enum class Edits { kFeatures, kMesh };

struct ToolRow {
  ToolId tool;
  std::string_view label;  ///< of its button; in lower case in the help
  char key;
  Edits edits;
  std::string_view hint;               ///< status line, while nothing else is to be said
  std::string_view hint_without_mesh;  ///< instead of `hint` while there is no mesh; empty: `hint`
};

inline constexpr ToolRow kTools[] = {
    {ToolId::kSelect, "Select", '1', Edits::kFeatures, "click or drag a box to select; drag to move", {}},
    {ToolId::kLine, "Line", '2', Edits::kFeatures, "drag a line along something that both pictures have", {}},
    {ToolId::kPoint, "Point", '3', Edits::kFeatures, "click a point that both pictures have", {}},
    {ToolId::kCurve,
     "Curve",
     '4',
     Edits::kFeatures,
     "click along a curve; Enter ends it, its first point closes it",
     {}},
    {ToolId::kMesh, "Mesh", '5', Edits::kMesh, "drag vertices; c and r add a column and a row at the mouse",
     "click a picture to lay a mesh over both"},
};

/// @pre the table has a row for it.
constexpr const ToolRow& row_of(ToolId tool) {
  const ToolRow* row = kTools;
  while (row->tool != tool) ++row;
  return *row;
}

/// What the result pane shows.
enum class Show { kDissolve, kSource, kDestination, kDifference, kGrid };

struct ShowRow {
  Show show;
  std::string_view label;  ///< of its button; in lower case in the help
};

/// In the order in which a key goes through them.
inline constexpr ShowRow kShows[] = {{Show::kDissolve, "Dissolve"},
                                     {Show::kSource, "Source"},
                                     {Show::kDestination, "Destination"},
                                     {Show::kDifference, "Difference"},
                                     {Show::kGrid, "Grid"}};

struct Switches {
  bool locked = true;    ///< both pictures zoom and pan together
  bool snap = true;      ///< to ends of other features and to edges
  bool onion = false;    ///< features at several moments
  bool folds = true;     ///< painted red
  bool loupe = false;    ///< a magnifier at the mouse
  bool features = true;  ///< marks are drawn
};

struct Toggle {
  bool Switches::*flag;
  bool operator==(const Toggle&) const = default;
};

struct SwitchRow {
  Toggle toggle;
  std::string_view label;
  char key;
  std::string_view help;
};

/// In the order of their buttons.
inline constexpr SwitchRow kSwitches[] = {
    {{&Switches::locked}, "Lock", 't', "pictures zoom and move together"},
    {{&Switches::snap}, "Snap", 'b', "snap to ends and edges"},
    {{&Switches::features}, "Marks", 'm', "marks"},
    {{&Switches::onion}, "Onion", 'o', "onion skin: the marks at five moments"},
    {{&Switches::folds}, "Folds", 'f', "folds in red"},
    {{&Switches::loupe}, "Loupe", 'p', "loupe"},
};

/// Actions without a value.
enum class Command {
  kEndCurve,
  kAddColumnHere,  ///< at the mouse
  kAddRowHere,
  kAddColumn,  ///< in the middle of the widest gap
  kAddRow,
  kRemoveColumn,  ///< of the first selected vertex
  kRemoveRow,
  kSelectAll,
  kSelectNext,
  kSwapEnds,
  kSwapEndsHere,  ///< on the side under the mouse
  kDuplicate,
  kErase,
  kName,
  kGroup,
  kUndo,
  kRedo,
  kEscape,  ///< ends the innermost thing in progress
  kFit,
  kPlay,
  kNextSpeed,
  kSlower,
  kFaster,
  kNextShow,
  kInherit,     ///< the selected features forget their own tuning
  kNextMethod,  ///< lines or mesh
  kSave,
  kClose,
  kHelp
};

/// Moves what is selected, px of the screen.
struct Nudge {
  int x = 0, y = 0;
  bool operator==(const Nudge&) const = default;
};

/// Stops playing and steps by this many frames.
struct StepFrames {
  int frames = 0;
  bool operator==(const StepFrames&) const = default;
};

/// Stops playing and goes to t.
struct GoTo {
  double t = 0;
  bool operator==(const GoTo&) const = default;
};

/// The slider of t.
struct TimeSlider {
  bool operator==(const TimeSlider&) const = default;
};

/// Answers the question by one of its keys.
struct Answer {
  char key = 0;
  bool operator==(const Answer&) const = default;
};

/// A Tuning is its slider. A TimingKind goes on to the next easing of that timing.
using Action =
    std::variant<Command, ToolId, Show, Toggle, Nudge, StepFrames, GoTo, TimeSlider, Tuning, TimingKind, Answer>;

}  // namespace morphkit::edit
