// What keys do. One table says it: the dispatcher looks in it, the help overlay and docs/edit.md show it.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cli/edit/gestures.h"
#include "cli/edit/help_lines.h"
#include "cli/edit/hit_test.h"

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
       [](G& g, int key) { return done([&] { g.choose_tool(static_cast<Tool>(key - '1')); }); }},
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
      {{'a'}, {"Select and change", "a", "select all"}, [](G& g, int) { return done([&] { g.model_.held.reset(); g.model_.document.select_all(); }); }},
      {{kKeyTab}, {"Select and change", "Tab", "select the next mark"}, [](G& g, int) { return done([&] { g.next_feature(); }); }},
      {{'i', 'j', 'k', 'l'}, {"Select and change", "i j k l", "nudge up, left, down, right by a screen pixel"},
       [](G& g, int key) { return done([&] { g.nudge(key); }); }},
      {{'e'}, {"Select and change", "e", "swap the ends, on both pictures"},
       [](G& g, int) { return done([&] { g.model_.document.swap_ends_selected(); g.model_.held.reset(); }); }},
      {{'w'}, {"Select and change", "w", "swap the ends on the picture under the mouse"},
       [](G& g, int) { return done([&] { g.model_.document.swap_end_on(g.side_under_mouse()); g.model_.held.reset(); }); }},
      {{'d'}, {"Select and change", "d", "duplicate"},
       [](G& g, int) { return done([&] { g.model_.held.reset(); g.model_.document.duplicate_selected({12, 12}); }); }},
      {{kKeyDelete, kKeyBackspace, 'x'}, {"Select and change", "Delete, Backspace, x", "delete"}, [](G& g, int) { return done([&] { g.erase(); }); }},
      {{'n'}, {"Select and change", "n", "name"}, [](G& g, int) { return done([&] { g.begin_entry(Entry::What::kName); }); }},
      {{'g'}, {"Select and change", "g", "put into a group"}, [](G& g, int) { return done([&] { g.begin_entry(Entry::What::kGroup); }); }},
      {{'z'}, {"Select and change", "z", "undo"}, [](G& g, int) { return done([&] { g.undo(true); }); }},
      {{'y'}, {"Select and change", "y", "redo"}, [](G& g, int) { return done([&] { g.undo(false); }); }},
      {{kKeyEscape}, {"Select and change", "Esc", "leave what is going on; select nothing"}, [](G& g, int) { return done([&] { g.leave(); }); }},

      {{}, {"See", "wheel", "zoom at the mouse"}, nullptr},
      {{}, {"See", "right or middle drag", "move the picture; the result by any button"}, nullptr},
      {{'0'}, {"See", "0, double-click", "fit the pictures into their panes"}, [](G& g, int) { return done([&] { g.fit(); }); }},
      {{kKeySpace}, {"See", "Space", "play, pause"}, [](G& g, int) { return done([&] { g.model_.playing = !g.model_.playing; }); }},
      {{'-', '='}, {"See", "- =", "slower, faster"},
       [](G& g, int key) { return done([&] { g.model_.speed = std::clamp(g.model_.speed * (key == '-' ? 0.5 : 2), 0.25, 4.0); }); }},
      {{'[', ']'}, {"See", "[ ]", "a frame back, a frame on"}, [](G& g, int key) { return done([&] { g.step_frames(key == '[' ? -1 : 1); }); }},
      {{kKeyHome, kKeyEnd}, {"See", "Home, End", "source, destination"},
       [](G& g, int key) { return done([&] { g.model_.playing = false; g.model_.t = key == kKeyHome ? 0 : 1; }); }},
      {{'v'}, {"See", "v", "show the next: dissolve, source, destination, difference, grid"},
       [](G& g, int) { return done([&] { g.model_.show = static_cast<Show>((static_cast<int>(g.model_.show) + 1) % 5); }); }},
      {{'o'}, {"See", "o", "onion skin: the marks at five moments"}, [](G& g, int) { return done([&] { g.model_.switches.onion ^= true; }); }},
      {{'f'}, {"See", "f", "folds in red"}, [](G& g, int) { return done([&] { g.model_.switches.folds ^= true; }); }},
      {{'m'}, {"See", "m", "marks"}, [](G& g, int) { return done([&] { g.model_.switches.features ^= true; }); }},
      {{'p'}, {"See", "p", "loupe"}, [](G& g, int) { return done([&] { g.model_.switches.loupe ^= true; }); }},
      {{'t'}, {"See", "t", "pictures zoom and move together"}, [](G& g, int) { return done([&] { g.model_.switches.locked ^= true; g.follow_view(Pane::kSource); }); }},
      {{'b'}, {"See", "b", "snap to ends and edges"}, [](G& g, int) { return done([&] { g.model_.switches.snap ^= true; }); }},

      {{'s'}, {"File", "s", "save"}, [](G&, int) { return std::optional(Wish::kSave); }},
      {{'q'}, {"File", "q", "close"}, [](G&, int) { return std::optional(Wish::kClose); }},
      {{'h', kKeyF1}, {"File", "h, F1", "this help"}, [](G& g, int) { return done([&] { g.model_.help = true; }); }},
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

void Gestures::answer(int key) {
  const std::vector<Question::Answer>& answers = model_.question->answers;
  if (key == kKeyEnter) model_.answer = answers.front().key;
  if (key == kKeyEscape) model_.answer = answers.back().key;
  for (const Question::Answer& candidate : answers)
    if (key == candidate.key) model_.answer = candidate.key;
}

void Gestures::type(int key) {
  constexpr std::size_t kLongest = 64;
  std::string& text = model_.entry->text;
  if (key == kKeyShift) {
    capital_ = true;
    return;
  }
  if (key == kKeyEnter) return accept_entry();
  if (key == kKeyEscape) {
    model_.entry.reset();
  } else if (key == kKeyBackspace || key == kKeyDelete) {
    if (!text.empty()) text.pop_back();
  } else if (key >= ' ' && key < 127 && text.size() < kLongest) {
    const bool letter = key >= 'a' && key <= 'z';
    text += static_cast<char>(letter && capital_ ? key - 'a' + 'A' : key);
  }
  capital_ = false;
}

void Gestures::begin_entry(Entry::What what) {
  const Selection& selection = model_.document.selection();
  if (selection.features.empty()) return say("select something first");
  if (what == Entry::What::kName && selection.features.size() > 1) return say("select one mark to name it");
  const project::Feature& first =
      model_.document.project().features[static_cast<std::size_t>(selection.features.front())];
  model_.entry = Entry{what, what == Entry::What::kName ? first.id : first.group};
  capital_ = false;
}

void Gestures::accept_entry() {
  const Entry entry = *std::exchange(model_.entry, std::nullopt);
  Document& document = model_.document;
  if (document.selection().features.empty()) return;
  if (entry.what == Entry::What::kGroup) {
    document.group_selected(entry.text);
    return say(entry.text.empty() ? "in no group" : fmt::format("in the group {}", entry.text));
  }
  const auto problem = document.rename(document.selection().features.front(), entry.text);
  say(problem ? *problem : fmt::format("named {}", entry.text));
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

void Gestures::choose_tool(Tool tool) {
  if (model_.sketch) drop();
  if ((tool == Tool::kMesh) != (model_.tool == Tool::kMesh)) select({});
  model_.tool = tool;
  if (tool == Tool::kMesh && !model_.document.has_mesh()) say("click a picture to lay a mesh over both");
}

void Gestures::end_curve(bool closed) {
  if (!model_.sketch || model_.sketch->tool != Tool::kCurve) return;
  const Sketch sketch = *std::exchange(model_.sketch, std::nullopt);
  model_.snapped.reset();
  const int feature = model_.document.add_curve(sketch.side, sketch.points, closed);
  if (feature < 0) return say("too few points for a curve");
  tell_of_new();
}

void Gestures::erase() {
  if (model_.sketch && model_.sketch->tool == Tool::kCurve) {
    model_.sketch->points.pop_back();
    if (model_.sketch->points.empty()) drop();
    return;
  }
  const std::vector<int> selected = model_.document.selection().features;
  if (selected.empty()) return say("nothing is selected");
  const std::string first = model_.document.project().features[static_cast<std::size_t>(selected.front())].id;
  model_.held.reset();
  model_.document.erase_selected();
  say(selected.size() == 1 ? fmt::format("{} deleted", first) : fmt::format("{} marks deleted", selected.size()));
}

void Gestures::undo(bool back) {
  if (model_.sketch) return drop();
  model_.held.reset();
  const bool was = back ? model_.document.undo() : model_.document.redo();
  if (was) return say(back ? "undone" : "redone");
  say(back ? "nothing to undo" : "nothing to redo");
}

void Gestures::nudge(int key) {
  const SideName side = side_under_mouse();
  const double px = 1 / model_.view(pane_of(side)).zoom;
  const cv::Point2d by = key == 'i'   ? cv::Point2d(0, -px)
                         : key == 'j' ? cv::Point2d(-px, 0)
                         : key == 'k' ? cv::Point2d(0, px)
                                      : cv::Point2d(px, 0);
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

void Gestures::next_feature() {
  const int count = static_cast<int>(model_.document.project().features.size());
  if (count == 0) return;
  const std::vector<int>& selected = model_.document.selection().features;
  select({{selected.empty() ? 0 : (selected.back() + 1) % count}, {}});
}

void Gestures::step_frames(int frames) {
  model_.playing = false;
  const int last = std::max(1, model_.document.project().output.frames - 1);
  const double frame = std::round(model_.t * last) + frames;
  model_.t = std::clamp(frame / last, 0.0, 1.0);
}

void Gestures::add_to_mesh(bool column) {
  if (model_.tool != Tool::kMesh || !model_.document.has_mesh())
    return say("there is no mesh here: choose its tool and click a picture");
  const std::optional<Pane> pane = layout_.pane_at(model_.mouse);
  std::optional<MeshPlace> place;
  if (pane && *pane != Pane::kResult)
    place = mesh_place_at(model_.document, side_of(*pane), to_content(model_, layout_, *pane, model_.mouse));
  if (!place) return say("point at the place in the mesh");
  // Not so near to what is there that nothing could lie between.
  constexpr double kLeast = 0.05;
  const double share = std::clamp(column ? place->across : place->down, kLeast, 1 - kLeast);
  select({});
  if (column) {
    model_.document.insert_column(place->column, share);
  } else {
    model_.document.insert_row(place->row, share);
  }
}

void Gestures::remove_from_mesh(bool column) {
  const std::vector<int> vertices = model_.document.selection().vertices;
  if (vertices.empty()) return say("select a vertex of it first");
  const int columns = model_.document.project().mesh->columns;
  model_.held.reset();
  const bool removed = column ? model_.document.remove_column(vertices.front() % columns)
                              : model_.document.remove_row(vertices.front() / columns);
  if (!removed) say("the border of the mesh stays");
}

void Gestures::next_easing(Progress which) {
  const motion::Easing choices[] = {motion::LinearEase{}, motion::SineEase{}, motion::SinusoidalEase{},
                                    motion::ParabolicEase{}, motion::CubicBezierEase{}};
  motion::Timing timing = model_.document.timing(which);
  timing.easing = choices[(timing.easing.index() + 1) % std::size(choices)];
  model_.document.set_timing(which, timing);
}

void Gestures::fit() {
  model_.fit_views();
}

void Gestures::act(const Widget& widget) {
  Switches& on = model_.switches;
  switch (widget.action) {
    case Action::kTool:
      return choose_tool(static_cast<Tool>(widget.value));
    case Action::kShow:
      model_.show = static_cast<Show>(widget.value);
      return;
    case Action::kPlay:
      model_.playing = !model_.playing;
      return;
    case Action::kSpeed:
      model_.speed = model_.speed >= 4 ? 0.25 : model_.speed * 2;
      return;
    case Action::kShape:
      return next_easing(Progress::kShape);
    case Action::kDissolve:
      return next_easing(Progress::kDissolve);
    case Action::kInherit:
      return model_.document.untune();
    case Action::kMethod: {
      const bool mesh = model_.document.method() == project::Method::kMesh;
      return model_.document.set_method(mesh ? project::Method::kLines : project::Method::kMesh);
    }
    case Action::kAddColumn:
    case Action::kAddRow:
      return add_to_largest_gap(widget.action == Action::kAddColumn);
    case Action::kRemoveColumn:
    case Action::kRemoveRow:
      return remove_from_mesh(widget.action == Action::kRemoveColumn);
    case Action::kLock:
      on.locked = !on.locked;
      return follow_view(Pane::kSource);
    case Action::kSnap:
      on.snap = !on.snap;
      return;
    case Action::kOnion:
      on.onion = !on.onion;
      return;
    case Action::kFolds:
      on.folds = !on.folds;
      return;
    case Action::kLoupe:
      on.loupe = !on.loupe;
      return;
    case Action::kFeatures:
      on.features = !on.features;
      return;
    case Action::kUndo:
    case Action::kRedo:
      return undo(widget.action == Action::kUndo);
    case Action::kFit:
      return fit();
    case Action::kHelp:
      model_.help = true;
      return;
    case Action::kAnswer:
      model_.answer = static_cast<char>(widget.value);
      return;
    case Action::kTime:
    case Action::kTune:
    case Action::kSave:
      return;  // sliders and wishes, seen to before
  }
}

void Gestures::add_to_largest_gap(bool column) {
  const project::Mesh& mesh = *model_.document.project().mesh;
  const std::vector<cv::Point2d> vertices = model_.document.mesh_vertices(SideName::kSource);
  const auto at = [&](int i) {
    return vertices[static_cast<std::size_t>(column ? (mesh.rows / 2) * mesh.columns + i
                                                    : i * mesh.columns + mesh.columns / 2)];
  };
  int widest = 0;
  double width = -1;
  for (int i = 0; i + 1 < (column ? mesh.columns : mesh.rows); ++i) {
    const cv::Point2d gap = at(i + 1) - at(i);
    if (std::hypot(gap.x, gap.y) <= width) continue;
    width = std::hypot(gap.x, gap.y);
    widest = i;
  }
  select({});
  if (column) {
    model_.document.insert_column(widest, 0.5);
  } else {
    model_.document.insert_row(widest, 0.5);
  }
}

}  // namespace morphkit::edit
