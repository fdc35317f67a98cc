// What widgets and keys do alike.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cli/edit/hand/gestures.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::optional<Wish> Gestures::act(Action action, int value) {
  Switches& on = model_.switches;
  switch (action) {
    case Action::kTool:
      choose_tool(static_cast<Tool>(value));
      break;
    case Action::kShow:
      model_.show = static_cast<Show>(value);
      break;
    case Action::kPlay:
      model_.playing = !model_.playing;
      break;
    case Action::kSpeed:
      model_.speed = model_.speed >= 4 ? 0.25 : model_.speed * 2;
      break;
    case Action::kShape:
    case Action::kDissolve:
      next_easing(action == Action::kShape ? Progress::kShape : Progress::kDissolve);
      break;
    case Action::kInherit:
      model_.document.untune();
      break;
    case Action::kMethod: {
      const bool mesh = model_.document.method() == project::MethodName::kMesh;
      model_.document.set_method(mesh ? project::MethodName::kLines : project::MethodName::kMesh);
      break;
    }
    case Action::kAddColumn:
    case Action::kAddRow:
      add_to_largest_gap(action == Action::kAddColumn);
      break;
    case Action::kRemoveColumn:
    case Action::kRemoveRow:
      remove_from_mesh(action == Action::kRemoveColumn);
      break;
    case Action::kLock:
      on.locked = !on.locked;
      follow_view(Pane::kSource);
      break;
    case Action::kSnap:
      on.snap = !on.snap;
      break;
    case Action::kOnion:
      on.onion = !on.onion;
      break;
    case Action::kFolds:
      on.folds = !on.folds;
      break;
    case Action::kLoupe:
      on.loupe = !on.loupe;
      break;
    case Action::kFeatures:
      on.features = !on.features;
      break;
    case Action::kUndo:
    case Action::kRedo:
      undo(action == Action::kUndo);
      break;
    case Action::kSave:
      return Wish::kSave;
    case Action::kFit:
      model_.fit_views();
      break;
    case Action::kHelp:
      model_.help = true;
      break;
    case Action::kAnswer:
      model_.answer = static_cast<char>(value);
      break;
    case Action::kTime:
    case Action::kTune:
      break;  // sliders, which are dragged
  }
  return std::nullopt;
}

void Gestures::choose_tool(Tool tool) {
  if (tool != model_.tool && sketches_curve()) end_curve(false);
  if (model_.sketch && !sketches_curve()) drop();
  if ((tool == Tool::kMesh) != (model_.tool == Tool::kMesh)) select({});
  model_.tool = tool;
  if (tool == Tool::kMesh && !model_.document.has_mesh()) say("click a picture to lay a mesh over both");
}

bool Gestures::sketches_curve() const {
  return model_.sketch && model_.sketch->tool == Tool::kCurve;
}

void Gestures::end_curve(bool closed) {
  if (!sketches_curve()) return;
  const Sketch sketch = *std::exchange(model_.sketch, std::nullopt);
  model_.snapped.reset();
  const int feature = model_.document.add_curve(sketch.side, sketch.points, closed);
  if (feature < 0) return say("too few points for a curve");
  tell_of_new();
}

void Gestures::tell_of_new() {
  const bool idle = model_.document.method() == project::MethodName::kMesh;
  say(fmt::format(
      "{}: {}", model_.document.project().features.back().id,
      idle ? "does nothing while the mesh warps; \"Warp: mesh\" below changes that" : "put its partner right"));
}

void Gestures::take_back_click() {
  model_.sketch->points.pop_back();
  if (model_.sketch->points.empty()) drop();
}

void Gestures::erase() {
  if (sketches_curve()) return take_back_click();
  const std::vector<int> selected = model_.document.selection().features;
  if (selected.empty()) return say("nothing is selected");
  const std::string first = model_.document.project().features[static_cast<std::size_t>(selected.front())].id;
  model_.held.reset();
  model_.document.erase_selected();
  say(selected.size() == 1 ? fmt::format("{} deleted", first) : fmt::format("{} marks deleted", selected.size()));
}

void Gestures::undo(bool back) {
  if (sketches_curve()) {
    if (back) take_back_click();
    return;
  }
  if (model_.sketch) return drop();
  model_.held.reset();
  const bool was = back ? model_.document.undo() : model_.document.redo();
  if (was) return say(back ? "undone" : "redone");
  say(back ? "nothing to undo" : "nothing to redo");
}

void Gestures::select_all() {
  model_.held.reset();
  if (model_.tool == Tool::kMesh) {
    model_.document.select_all_vertices();
  } else {
    model_.document.select_all_features();
  }
}

void Gestures::select_next() {
  const Document& document = model_.document;
  const bool mesh = model_.tool == Tool::kMesh;
  const std::size_t count = mesh ? document.mesh_vertices(kSource).size() : document.project().features.size();
  if (count == 0) return;
  const std::vector<int>& selected = mesh ? document.selection().vertices : document.selection().features;
  const int next = selected.empty() ? 0 : (selected.back() + 1) % static_cast<int>(count);
  select(mesh ? Selection{{}, {next}} : Selection{{next}, {}});
}

void Gestures::next_easing(Progress which) {
  const motion::Easing choices[] = {motion::LinearEase{}, motion::SineEase{}, motion::SinusoidalEase{},
                                    motion::ParabolicEase{}, motion::CubicBezierEase{}};
  const std::size_t now = model_.document.timing(which).easing.index();
  model_.document.set_easing(which, choices[(now + 1) % std::size(choices)]);
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

void Gestures::add_to_largest_gap(bool column) {
  const project::Mesh& mesh = *model_.document.project().mesh;
  const std::vector<cv::Point2d> vertices = model_.document.mesh_vertices(kSource);
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

void Gestures::remove_from_mesh(bool column) {
  const std::vector<int> vertices = model_.document.selection().vertices;
  if (vertices.empty()) return say("select a vertex of it first");
  const int columns = model_.document.project().mesh->columns;
  model_.held.reset();
  const bool removed = column ? model_.document.remove_column(vertices.front() % columns)
                              : model_.document.remove_row(vertices.front() / columns);
  if (!removed) say("the border of the mesh stays");
}

}  // namespace morphkit::edit
