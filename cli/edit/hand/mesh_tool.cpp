#include "cli/edit/hand/mesh_tool.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cli/edit/hand/box_drag.h"
#include "cli/edit/hand/mark_drag.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::unique_ptr<Drag> MeshTool::press(const Press& press) {
  if (const auto hit = hit_test(model(), context().panes(), press.mouse.position)) {
    std::unique_ptr<Drag> drag = press_mark(context(), press, *hit);
    if (drag && document().method() != project::MethodName::kMesh)
      context().say("the lines warp: \"Warp: lines\" below lets the mesh do it");
    return drag;
  }
  if (press.again) {
    model().fit_views();
    return nullptr;
  }
  model().switches.features = true;
  if (document().has_mesh()) return std::make_unique<BoxDrag>(context(), press);
  document().set_method(project::MethodName::kMesh);
  context().say("a mesh on both pictures: drag its vertices");
  return nullptr;
}

bool MeshTool::perform(Command command) {
  switch (command) {
    case Command::kAddColumnHere:
    case Command::kAddRowHere:
      add_at_mouse(command == Command::kAddColumnHere);
      return true;
    case Command::kAddColumn:
    case Command::kAddRow:
      add_to_widest_gap(command == Command::kAddColumn);
      return true;
    case Command::kRemoveColumn:
    case Command::kRemoveRow:
      remove(command == Command::kRemoveColumn);
      return true;
    case Command::kSelectAll:
      if (!chosen()) return false;
      model().held.reset();
      document().select_all_vertices();
      return true;
    case Command::kSelectNext:
      if (!chosen()) return false;
      select_next();
      return true;
    default:
      return false;
  }
}

void MeshTool::add_at_mouse(bool column) {
  if (!chosen() || !document().has_mesh())
    return context().say("there is no mesh here: choose its tool and click a picture");
  const std::optional<Pane> pane = context().panes().pane_at(model().mouse);
  std::optional<MeshPlace> place;
  if (pane && *pane != Pane::kResult)
    place = mesh_place_at(model(), side_of(*pane), context().content_at(*pane, model().mouse));
  if (!place) return context().say("point at the place in the mesh");
  // Not so near to a vertex that nothing could lie between.
  constexpr double kLeast = 0.05;
  const double share = std::clamp(column ? place->across : place->down, kLeast, 1 - kLeast);
  insert(column, column ? place->column : place->row, share);
}

void MeshTool::add_to_widest_gap(bool column) {
  const project::Mesh& mesh = *document().project().mesh;
  const std::vector<cv::Point2d> vertices = document().mesh_vertices(project::kSource);
  const auto at = [&](int i) {
    return vertices[static_cast<std::size_t>(column ? (mesh.rows / 2) * mesh.columns + i
                                                    : i * mesh.columns + mesh.columns / 2)];
  };
  int widest = 0;
  double width = -1;
  for (int i = 0; i + 1 < (column ? mesh.columns : mesh.rows); ++i) {
    const double gap = length(at(i + 1) - at(i));
    if (gap <= width) continue;
    width = gap;
    widest = i;
  }
  insert(column, widest, 0.5);
}

void MeshTool::insert(bool column, int after, double share) {
  context().select({});
  if (column) {
    document().insert_column(after, share);
  } else {
    document().insert_row(after, share);
  }
}

void MeshTool::remove(bool column) {
  const std::vector<int> vertices = document().selection().vertices;
  if (vertices.empty()) return context().say("select a vertex of it first");
  const int columns = document().project().mesh->columns;
  model().held.reset();
  const bool removed =
      column ? document().remove_column(vertices.front() % columns) : document().remove_row(vertices.front() / columns);
  if (!removed) context().say("the border of the mesh stays");
}

void MeshTool::select_next() {
  const int count = static_cast<int>(document().mesh_vertices(project::kSource).size());
  if (count == 0) return;
  const std::vector<int>& selected = document().selection().vertices;
  context().select({{}, {selected.empty() ? 0 : (selected.back() + 1) % count}});
}

}  // namespace morphkit::edit
