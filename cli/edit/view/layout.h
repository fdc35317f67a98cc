#pragma once
// Where everything on the canvas is. Both drawing and clicking ask here.

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

namespace morphkit::edit {

struct Model;

enum class Pane { kSource, kDestination, kResult };
inline constexpr Pane kPanes[] = {Pane::kSource, Pane::kDestination, Pane::kResult};

/// What a widget does when it is clicked or dragged.
enum class Action {
  kTool,  ///< value: Tool
  kShow,  ///< value: Show
  kPlay,
  kSpeed,
  kTime,   ///< slider of t
  kTune,   ///< slider; value: Tuning
  kShape,  ///< the next easing
  kDissolve,
  kInherit,  ///< the selected features forget their own tuning
  kMethod,   ///< lines or mesh
  kAddColumn,
  kRemoveColumn,
  kAddRow,
  kRemoveRow,
  kLock,
  kSnap,
  kOnion,
  kFolds,
  kLoupe,
  kFeatures,
  kUndo,
  kRedo,
  kSave,
  kFit,
  kHelp,
  kAnswer  ///< value: the key of the answer
};

struct Widget {
  Action action = Action::kTool;
  int value = 0;
  cv::Rect rect;  ///< canvas px
  std::string label;
  bool on = false;  ///< pressed in, chosen
  bool enabled = true;
  std::optional<double> slider;  ///< position of the knob in [0, 1]; nothing: a button
};

struct Layout {
  double scale = 1;  ///< of type and widgets
  cv::Rect top;      ///< tools, switches, commands
  cv::Rect heads[3];
  cv::Rect panes[3];  ///< source, destination, result; `heads` with their titles above them
  cv::Rect time;      ///< play, slider of t, speed
  cv::Rect tuning;
  cv::Rect status;
  cv::Rect card;  ///< of the question; empty if there is none
  std::vector<Widget> widgets;

  const cv::Rect& pane(Pane pane) const { return panes[static_cast<int>(pane)]; }
  const cv::Rect& head(Pane pane) const { return heads[static_cast<int>(pane)]; }
  std::optional<Pane> pane_at(cv::Point position) const;
  const Widget* widget_at(cv::Point position) const;  ///< the topmost; null if none
};

/// Of a model at its canvas_size, which is at least kLeastCanvas. While a question stands, its answers are the only
/// widgets.
Layout layout_of(const Model& model);

/// The same as if no question stood.
Layout layout_beneath(const Model& model);

/// The panes alone, which do not depend on the rest of the model.
Layout panes_of(cv::Size canvas);

inline const cv::Size kLeastCanvas{960, 540};

/// A slider's knob in [0, 1] as the value of a Tuning, and back. Short distances matter most: a goes by the square of
/// the knob up to 100 px; b to 4 and p to 1 evenly. Values beyond are shown at the end.
double tuning_from_slider(int tuning, double slider);
double slider_from_tuning(int tuning, double value);

/// The part of a slider's rectangle along which its knob moves: its left edge is 0, its right edge 1.
cv::Rect slider_track(const Widget& widget, double scale);

/// Where a press takes hold of the knob: along the track and as high as the slider.
cv::Rect slider_grip(const Widget& widget, double scale);

}  // namespace morphkit::edit
