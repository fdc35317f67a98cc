#include "cli/edit/hand/slider_drag.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace morphkit::edit {

SliderDrag::SliderDrag(ToolContext& context, Widget slider, cv::Point position)
    : context_(context), slider_(std::move(slider)) {
  if (std::holds_alternative<Tuning>(slider_.action)) context_.document().begin();
  slide(position);
}

void SliderDrag::slide(cv::Point position) {
  const cv::Rect track = slider_track(slider_, context_.panes().scale);
  const double knob = std::clamp(static_cast<double>(position.x - track.x) / track.width, 0.0, 1.0);
  if (const Tuning* tuning = std::get_if<Tuning>(&slider_.action)) {
    context_.document().tune(*tuning, tuning_from_slider(*tuning, knob));
    return;
  }
  context_.model().playing = false;
  context_.model().t = knob;
}

void SliderDrag::release(const Mouse&) {
  if (context_.document().in_step()) context_.document().end();
}

}  // namespace morphkit::edit
