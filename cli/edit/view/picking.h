#pragma once
// What lies under the mouse.

#include <optional>
#include <vector>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"

namespace morphkit::edit {

/// How near the mouse must be, in units of Layout::scale.
inline constexpr double kHandleReach = 9;
inline constexpr double kBodyReach = 6;

/// The side of a pane with a picture.
inline SideIndex side_of(Pane pane) {
  return pane == Pane::kDestination ? kDestination : kSource;
}
inline Pane pane_of(SideIndex side) {
  return side == kDestination ? Pane::kDestination : Pane::kSource;
}

/// A canvas position as one of the content of a pane, and back.
cv::Point2d to_content(const Model& model, const Layout& layout, Pane pane, cv::Point2d canvas);
cv::Point2d to_canvas(const Model& model, const Layout& layout, Pane pane, cv::Point2d content);

/// The marks of a feature on a side as a polyline, px of the picture: its ends, or a curve flattened so that it looks
/// smooth at any zoom.
std::vector<cv::Point2d> outline_of(const project::Feature& feature, SideIndex side);

/// What a press at a canvas position would hold: the nearest point within kHandleReach, else the nearest feature within
/// kBodyReach. With the mesh tool the vertices are what can be held, with the others the features;
/// what is not shown cannot be held.
std::optional<Handle> handle_at(const Model& model, const Layout& layout, cv::Point2d canvas);

/// Where the point that a handle names is, px of the picture; of a whole feature its first one.
cv::Point2d position_of(const Document& document, const Handle& handle);

/// The cell of the mesh at a position and where in it, or nothing outside.
struct MeshPlace {
  int column = 0, row = 0;      ///< of the vertex before
  double across = 0, down = 0;  ///< in [0, 1]
};
std::optional<MeshPlace> mesh_place_at(const Document& document, SideIndex side, cv::Point2d position);

}  // namespace morphkit::edit
