// What keys do. One table says it: the dispatcher looks in it, the help overlay and docs/edit.md show it.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cli/edit/hand/gestures.h"
#include "cli/edit/hand/snap.h"
#include "cli/edit/view/help_lines.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

/// A line of the help. Without keys, one about the mouse.
struct KeyRow {
  using Act = std::optional<Wish> (*)(Gestures& gestures, int key);
  std::array<int, 5> keys;  ///< 0: none
  HelpLine help;
  Act act;

  static std::span<const KeyRow> all();
};

namespace {

/// For what grants no wish.
template <typename Work>
std::optional<Wish> done(const Work& work) {
  work();
  return std::nullopt;
}

}  // namespace

std::span<const KeyRow> KeyRow::all() {
  using G = Gestures;
  static const KeyRow rows[] = {
      // clang-format off
      {{'1', '2', '3', '4', '5'}, {"Mark", "1 2 3 4 5", "tools: select, line, point, curve, mesh"},
       [](G& g, int key) { return g.act(Action::kTool, key - '1'); }},
      {{}, {"Mark", "drag", "a line; a click places a point of the others"}, nullptr},
      {{kKeyEnter}, {"Mark", "Enter, double-click", "end a curve; click its first point to close it"},
       [](G& g, int) { return done([&] { g.end_curve(false); }); }},
      {{}, {"Mark", "Ctrl + drag", "draw, even over a mark that could be dragged"}, nullptr},
      {{}, {"Mark", "Alt", "held: do not snap"}, nullptr},
      {{'c'}, {"Mark", "c", "mesh: add a column at the mouse"}, [](G& g, int) { return done([&] { g.add_to_mesh(true); }); }},
      {{'r'}, {"Mark", "r", "mesh: add a row at the mouse"}, [](G& g, int) { return done([&] { g.add_to_mesh(false); }); }},
      {{','}, {"Mark", ",", "mesh: remove the column of the selected vertex"}, [](G& g, int) { return done([&] { g.remove_from_mesh(true); }); }},
      {{'.'}, {"Mark", ".", "mesh: remove its row"}, [](G& g, int) { return done([&] { g.remove_from_mesh(false); }); }},

      {{}, {"Select and change", "click", "select; drag an end, or the whole"}, nullptr},
      {{}, {"Select and change", "Shift + click", "take into the selection, or out"}, nullptr},
      {{}, {"Select and change", "Shift + drag", "select what lies in a box"}, nullptr},
      {{'a'}, {"Select and change", "a", "select all"}, [](G& g, int) { return done([&] { g.select_all(); }); }},
      {{kKeyTab}, {"Select and change", "Tab", "select the next mark"}, [](G& g, int) { return done([&] { g.select_next(); }); }},
      {{'i', 'j', 'k', 'l'}, {"Select and change", "i j k l", "nudge up, left, down, right by a screen pixel"},
       [](G& g, int key) { return done([&] { g.nudge(key); }); }},
      {{'e'}, {"Select and change", "e", "swap the ends, on both pictures"},
       [](G& g, int) { return done([&] { g.model_.document.swap_ends_selected(); g.model_.held.reset(); }); }},
      {{'w'}, {"Select and change", "w", "swap the ends on the picture under the mouse"},
       [](G& g, int) { return done([&] { g.model_.document.swap_end_on(g.side_at_hand()); g.model_.held.reset(); }); }},
      {{'d'}, {"Select and change", "d", "duplicate"},
       [](G& g, int) { return done([&] { g.model_.held.reset(); g.model_.document.duplicate_selected({12, 12}); }); }},
      {{kKeyDelete, kKeyBackspace, 'x'}, {"Select and change", "Delete, Backspace, x", "delete"}, [](G& g, int) { return done([&] { g.erase(); }); }},
      {{'n'}, {"Select and change", "n", "name"}, [](G& g, int) { return done([&] { g.begin_entry(Entry::What::kName); }); }},
      {{'g'}, {"Select and change", "g", "put into a group"}, [](G& g, int) { return done([&] { g.begin_entry(Entry::What::kGroup); }); }},
      {{'z'}, {"Select and change", "z", "undo; a curve's last click while it is drawn"}, [](G& g, int) { return g.act(Action::kUndo); }},
      {{'y'}, {"Select and change", "y", "redo"}, [](G& g, int) { return g.act(Action::kRedo); }},
      {{kKeyEscape}, {"Select and change", "Esc", "leave what is going on; select nothing"}, [](G& g, int) { return done([&] { g.leave(); }); }},

      {{}, {"See", "wheel", "zoom at the mouse"}, nullptr},
      {{}, {"See", "right or middle drag", "move the picture; the result by any button"}, nullptr},
      {{'0'}, {"See", "0, double-click", "fit the pictures into their panes"}, [](G& g, int) { return g.act(Action::kFit); }},
      {{kKeySpace}, {"See", "Space", "play, pause"}, [](G& g, int) { return g.act(Action::kPlay); }},
      {{'-', '='}, {"See", "- =", "slower, faster"},
       [](G& g, int key) { return done([&] { g.model_.speed = std::clamp(g.model_.speed * (key == '-' ? 0.5 : 2), 0.25, 4.0); }); }},
      {{'[', ']'}, {"See", "[ ]", "a frame back, a frame on"}, [](G& g, int key) { return done([&] { g.step_frames(key == '[' ? -1 : 1); }); }},
      {{kKeyHome, kKeyEnd}, {"See", "Home, End", "source, destination"},
       [](G& g, int key) { return done([&] { g.model_.playing = false; g.model_.t = key == kKeyHome ? 0 : 1; }); }},
      {{'v'}, {"See", "v", "show the next: dissolve, source, destination, difference, grid"},
       [](G& g, int) { return g.act(Action::kShow, (static_cast<int>(g.model_.show) + 1) % 5); }},
      {{'o'}, {"See", "o", "onion skin: the marks at five moments"}, [](G& g, int) { return g.act(Action::kOnion); }},
      {{'f'}, {"See", "f", "folds in red"}, [](G& g, int) { return g.act(Action::kFolds); }},
      {{'m'}, {"See", "m", "marks"}, [](G& g, int) { return g.act(Action::kFeatures); }},
      {{'p'}, {"See", "p", "loupe"}, [](G& g, int) { return g.act(Action::kLoupe); }},
      {{'t'}, {"See", "t", "pictures zoom and move together"}, [](G& g, int) { return g.act(Action::kLock); }},
      {{'b'}, {"See", "b", "snap to ends and edges"}, [](G& g, int) { return g.act(Action::kSnap); }},

      {{'s'}, {"File", "s", "save"}, [](G& g, int) { return g.act(Action::kSave); }},
      {{'q'}, {"File", "q", "close"}, [](G&, int) { return std::optional(Wish::kClose); }},
      {{'h', kKeyF1}, {"File", "h, F1", "this help"}, [](G& g, int) { return g.act(Action::kHelp); }},
      // clang-format on
  };
  return rows;
}

std::span<const HelpLine> help_lines() {
  static const std::vector<HelpLine> lines = [] {
    std::vector<HelpLine> result;
    for (const KeyRow& row : KeyRow::all()) result.push_back(row.help);
    return result;
  }();
  return lines;
}

std::optional<Wish> Gestures::key(int key) {
  layout_ = layout_of(model_);
  const std::optional<Wish> wish = press_key(key);
  layout_ = layout_of(model_);
  const bool free = drag_ == Drag::kNothing && !model_.question && !model_.help;
  model_.hover = free ? handle_at(model_, layout_, model_.mouse) : std::nullopt;
  return wish;
}

std::optional<Wish> Gestures::press_key(int key) {
  if (model_.question) {
    answer(key);
  } else if (model_.entry) {
    type(key);
  } else if (model_.help && key != kKeyShift) {
    model_.help = false;
  } else if (drag_ == Drag::kNothing || key == kKeyEscape) {  // else the hand has not finished
    if (key == kKeyShift) return std::nullopt;                // it announces another key
    model_.welcome = false;
    for (const KeyRow& row : KeyRow::all())
      if (key != 0 && std::ranges::find(row.keys, key) != row.keys.end()) return row.act(*this, key);
  }
  return std::nullopt;
}

void Gestures::nudge(int key) {
  const SideIndex side = side_at_hand();
  const double zoom = model_.view(pane_of(side)).zoom;
  const double px = 1 / zoom;
  const cv::Point2d by = rounded(key == 'i'   ? cv::Point2d(0, -px)
                                 : key == 'j' ? cv::Point2d(-px, 0)
                                 : key == 'k' ? cv::Point2d(0, px)
                                              : cv::Point2d(px, 0),
                                 zoom);
  Document& document = model_.document;
  if (document.selection().empty()) return say("nothing is selected");
  const auto& held = model_.held;
  // What was held may have gone: the project may have been replaced since.
  const bool alone = held && document.selection().features == std::vector{held->feature};
  if (alone && held->point >= 0 && held->side == side) {
    document.move_point(held->feature, side, held->point, position_of(document, *held) + by);
  } else {
    document.move_selected(side, by);
  }
}

bool Gestures::leave() {
  if (drag_ != Drag::kNothing || model_.sketch) {
    drop();
  } else if (model_.playing) {
    model_.playing = false;
  } else if (!model_.document.selection().empty()) {
    select({});
  } else {
    return false;
  }
  return true;
}

void Gestures::step_frames(int frames) {
  model_.playing = false;
  const int last = std::max(1, model_.document.project().output.frames - 1);
  const double frame = std::round(model_.t * last) + frames;
  model_.t = std::clamp(frame / last, 0.0, 1.0);
}

}  // namespace morphkit::edit
