#pragma once
// Pressing marks selects and drags them, in every tool.

#include <memory>

#include "cli/edit/hand/drag.h"

namespace morphkit::edit {

/// Presses a mark or vertex. With Shift or Ctrl it goes into the selection or out of it, and the result is null.
std::unique_ptr<Drag> press_mark(ToolContext& context, const Press& press, const Handle& handle);

/// Drags one point of a feature. Opens a step of undo if none is open, and ends it on release.
/// Owns where the point was at the press.
class PointDrag : public PictureDrag {
 public:
  PointDrag(ToolContext& context, const Press& press, const Handle& handle);
  void release(const Mouse& mouse) override;

 protected:
  void follow(const Mouse& mouse, cv::Point2d now) override;

 private:
  Handle handle_;
  cv::Point2d from_;  ///< picture px
};

/// Drags everything that is selected: features, or vertices. One step of undo.
class SelectionDrag : public PictureDrag {
 public:
  SelectionDrag(ToolContext& context, const Press& press, const Handle& handle);
  void release(const Mouse& mouse) override;

 protected:
  void follow(const Mouse& mouse, cv::Point2d now) override;

 private:
  Handle handle_;
};

}  // namespace morphkit::edit
