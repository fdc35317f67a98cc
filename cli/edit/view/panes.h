#pragma once
// The canvas divided into strips and panes. Depends on the size of the canvas alone.

#include <optional>

#include <opencv2/core/types.hpp>

namespace morphkit::edit {

enum class Pane { kSource, kDestination, kResult };
inline constexpr Pane kPanes[] = {Pane::kSource, Pane::kDestination, Pane::kResult};

struct Panes {
  double scale = 1;  ///< of type and widgets: 1 on a canvas of 1600x900
  cv::Rect top;      ///< tools, switches, commands
  cv::Rect heads[3];
  cv::Rect panes[3];  ///< source, destination, result; `heads` with their titles above them
  cv::Rect time;      ///< play, slider of t, speed
  cv::Rect tuning;
  cv::Rect status;

  const cv::Rect& pane(Pane pane) const { return panes[static_cast<int>(pane)]; }
  const cv::Rect& head(Pane pane) const { return heads[static_cast<int>(pane)]; }
  std::optional<Pane> pane_at(cv::Point position) const;
};

inline const cv::Size kMinCanvas{960, 540};

/// @param canvas  px, at least kMinCanvas.
Panes panes_of(cv::Size canvas);

}  // namespace morphkit::edit
