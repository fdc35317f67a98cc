#pragma once
// Where everything on the canvas is. Drawing and clicking both ask here.

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "cli/edit/view/actions.h"
#include "cli/edit/view/panes.h"

namespace morphkit::edit {

struct Model;

struct Widget {
  Action action;
  cv::Rect rect;  ///< canvas px
  std::string label;
  bool on = false;  ///< pressed in, chosen
  bool enabled = true;
  std::optional<double> slider;  ///< position of the knob in [0, 1]; nothing: a button
};

struct Layout : Panes {
  cv::Rect card;  ///< of the question; empty if there is none
  std::vector<Widget> widgets;

  const Widget* widget_at(cv::Point position) const;  ///< the topmost; null if none
};

/// Of a model at its canvas_size. While a question stands, its answers are the only widgets.
Layout layout_of(const Model& model);

/// The same as if no question stood.
Layout layout_beneath(const Model& model);

/// A slider's knob in [0, 1] as the value of a Tuning, and back. Short distances matter most: a goes by the square of
/// the knob up to 100 px; b to 4 and p to 1 evenly. Values beyond are shown at the end.
double tuning_from_slider(Tuning which, double slider);
double slider_from_tuning(Tuning which, double value);

/// The part of a slider's rectangle along which its knob moves: its left edge is 0, its right edge 1.
cv::Rect slider_track(const Widget& widget, double scale);

/// Where a press takes hold of the knob: along the track and as high as the slider.
cv::Rect slider_grip(const Widget& widget, double scale);

}  // namespace morphkit::edit
