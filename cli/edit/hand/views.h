#pragma once
// Zooming and panning the views of the panes.

#include "cli/edit/hand/drag.h"

namespace morphkit::edit {

/// Zooms the view under the mouse by the wheel; the content at the mouse stays where it is.
void zoom_by_wheel(Model& model, const Mouse& mouse);

/// If the pictures are locked, gives the other picture the view that shows the same part as `pane`.
void follow_view(Model& model, Pane pane);

/// Moves the content of a pane with the mouse, until it has just left the pane.
class PanDrag : public Drag {
 public:
  PanDrag(ToolContext& context, const Press& press) : context_(context), pane_(press.pane), last_(press.content) {}
  void move(const Mouse& mouse) override;
  void release(const Mouse&) override {}

 private:
  ToolContext& context_;
  Pane pane_;
  cv::Point2d last_;  ///< content px under the mouse
};

}  // namespace morphkit::edit
