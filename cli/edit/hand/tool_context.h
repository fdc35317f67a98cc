#pragma once
// What all tools share: the model, snapping, and the side that keys act on.

#include <functional>
#include <optional>
#include <string>

#include <opencv2/core/types.hpp>

#include "cli/edit/hand/input.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/panes.h"

namespace morphkit::edit {

/// Finds the strongest edge of a picture within `radius` px of a position, or nothing.
/// @param zoom  at which the picture is looked at.
using EdgeFinder =
    std::function<std::optional<cv::Point2d>(SideIndex side, cv::Point2d position, double radius, double zoom)>;

/// Largest distances for snapping to ends and edges, in units of Panes::scale.
inline constexpr double kEndReach = 8;
inline constexpr double kEdgeReach = 6;

/// A mouse travel below this is a click, in units of Panes::scale.
inline constexpr double kClickPx = 4;

double length(cv::Point2d d);

/// Owns the edge finder and the side of the last press. The model outlives it.
class ToolContext {
 public:
  ToolContext(Model& model, EdgeFinder edges);

  Model& model() const { return model_; }
  Document& document() const { return model_.document; }
  Panes panes() const { return panes_of(model_.canvas_size); }
  void say(std::string text) const { model_.message = std::move(text); }

  /// Changes the selection. Nothing is held then.
  void select(Selection selection) const;

  /// A canvas position in px of the content of a pane.
  cv::Point2d content_at(Pane pane, cv::Point position) const;
  /// Distance on the picture that is `units` of Panes::scale on the screen, px.
  double reach(Pane pane, double units) const { return units * panes().scale / model_.view(pane).zoom; }
  /// A picture position snapped to ends and edges, if snapping is on and Alt is up; else rounded for the file. Sets
  /// Model::snapped. @param except  feature whose own points are no targets; -1: none.
  cv::Point2d snapped(SideIndex side, cv::Point2d position, const Mouse& mouse, int except) const;

  /// The side that keys act on: under the mouse, else the side of the held mark, else of the last press.
  SideIndex active_side() const;
  void set_pressed_side(SideIndex side) { pressed_side_ = side; }

 private:
  Model& model_;
  EdgeFinder edges_;
  SideIndex pressed_side_ = project::kSource;
};

}  // namespace morphkit::edit
