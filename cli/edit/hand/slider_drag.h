#pragma once
// Dragging the knob of a slider.

#include "cli/edit/hand/drag.h"
#include "cli/edit/view/layout.h"

namespace morphkit::edit {

/// Sets t, or a tuning in one step of undo. Owns the slider as it was at the press.
class SliderDrag : public Drag {
 public:
  /// @param slider  its action is a TimeSlider or a Tuning.
  SliderDrag(ToolContext& context, Widget slider, cv::Point position);
  void move(const Mouse& mouse) override { slide(mouse.position); }
  void release(const Mouse& mouse) override;

 private:
  void slide(cv::Point position);

  ToolContext& context_;
  Widget slider_;
};

}  // namespace morphkit::edit
