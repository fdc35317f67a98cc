#pragma once
// Hit tests: which mark or vertex is under the mouse.

#include <optional>
#include <vector>

#include "cli/edit/view/model.h"
#include "cli/edit/view/panes.h"

namespace morphkit::edit {

/// Largest distance of a hit, in units of Panes::scale.
inline constexpr double kHandleReach = 9;
inline constexpr double kBodyReach = 6;

/// The side of a pane with a picture.
inline SideIndex side_of(Pane pane) {
  return pane == Pane::kDestination ? project::kDestination : project::kSource;
}
inline Pane pane_of(SideIndex side) {
  return side == project::kDestination ? Pane::kDestination : Pane::kSource;
}

/// A canvas position as one of the content of a pane, and back.
cv::Point2d to_content(const Model& model, const Panes& panes, Pane pane, cv::Point2d canvas);
cv::Point2d to_canvas(const Model& model, const Panes& panes, Pane pane, cv::Point2d content);

/// A mark on one side as a polyline, picture px. Curves are flattened finely enough to look smooth at any zoom.
std::vector<cv::Point2d> outline_of(const project::Mark& mark, const project::Points& points);

/// The vertices of the moment's mesh on one picture, px of it. @pre the moment has a mesh.
project::Points vertices_of(const Model& model, const project::Moment& moment, SideIndex side);

/// The nearest point within kHandleReach of a canvas position, else the nearest feature within kBodyReach. The mesh
/// tool hits vertices, the other tools hit features. Hidden marks are not hit.
std::optional<Handle> hit_test(const Model& model, const Panes& panes, cv::Point2d canvas);

/// Position of the point of a handle, picture px; of a whole feature its first point.
cv::Point2d position_of(const Model& model, const Handle& handle);

/// A position in a cell of the mesh.
struct MeshPlace {
  int column = 0, row = 0;      ///< of the vertex before
  double across = 0, down = 0;  ///< in [0, 1]
};
/// @return nothing outside of the mesh.
std::optional<MeshPlace> mesh_place_at(const Model& model, SideIndex side, cv::Point2d position);

}  // namespace morphkit::edit
