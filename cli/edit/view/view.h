#pragma once
// A view: zoom and centre of a picture in a pane.

#include <opencv2/core/types.hpp>

namespace morphkit::edit {

/// pane px = (picture - centre) * zoom + middle of the pane. Positions in the pane are relative to its top left corner.
struct View {
  double zoom = 1;     ///< pane px per picture px, kept in [kMinZoom, kMaxZoom]
  cv::Point2d centre;  ///< picture position in the middle of the pane, px

  cv::Point2d to_pane(cv::Point2d picture, cv::Size pane) const {
    return {(picture.x - centre.x) * zoom + pane.width / 2.0, (picture.y - centre.y) * zoom + pane.height / 2.0};
  }
  cv::Point2d to_picture(cv::Point2d in_pane, cv::Size pane) const {
    return {(in_pane.x - pane.width / 2.0) / zoom + centre.x, (in_pane.y - pane.height / 2.0) / zoom + centre.y};
  }
  bool operator==(const View&) const = default;
};

inline constexpr double kMinZoom = 1.0 / 256;
inline constexpr double kMaxZoom = 64;

/// The whole picture, centred, with a small margin.
View fitted(cv::Size picture, cv::Size pane);

/// Zooms by `factor`. The picture position at `in_pane` stays where it is.
View zoomed(const View& view, double factor, cv::Point2d in_pane, cv::Size pane);

/// The view of another picture that shows the same part: centre at the same fraction, zoom scaled by the widths.
View matching(const View& view, cv::Size picture, cv::Size other);

}  // namespace morphkit::edit
