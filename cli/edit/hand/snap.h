#pragma once
// Snap targets: ends of features, and edges in the picture.

#include <optional>

#include <opencv2/core.hpp>

#include "cli/edit/document/document.h"
#include "cli/edit/view/pyramid.h"

namespace morphkit::edit {

/// The strongest edge of the picture within `radius` px of a position, picture px, accurate to a fraction of a px.
/// Nothing if there is no clear edge. @param zoom  of the view: searches the pyramid level on screen.
std::optional<cv::Point2d> strongest_edge(const Pyramid& picture, cv::Point2d position, double radius, double zoom);

/// The nearest point of any feature but `except` on that side within `radius` px.
std::optional<cv::Point2d> nearest_end(const Document& document, SideIndex side, cv::Point2d position, double radius,
                                       int except);

/// Rounds to a power of ten that is at most a tenth of a screen px, so that numbers in the project file are short.
cv::Point2d rounded(cv::Point2d position, double zoom);

}  // namespace morphkit::edit
