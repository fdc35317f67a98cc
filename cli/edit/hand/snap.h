#pragma once
// Places that a hand probably means: ends of features, and edges of the picture.

#include <optional>

#include <opencv2/core.hpp>

#include "cli/edit/document/document.h"
#include "cli/edit/view/pyramid.h"

namespace morphkit::edit {

/// The strongest edge of the picture within `radius` px of a position (picture px; where the edge is strongest across
/// itself, to a fraction of a px), or nothing if no edge there stands out. @param zoom  as the picture is looked at.
std::optional<cv::Point2d> strongest_edge(const Pyramid& picture, cv::Point2d position, double radius, double zoom);

/// The nearest point of the features on that side within `radius` px, but for those of `except`.
std::optional<cv::Point2d> nearest_end(const Document& document, SideIndex side, cv::Point2d position, double radius,
                                       int except);

/// As fine as a hand can tell at this zoom, in a power of ten, so that what people read in the project file is short.
cv::Point2d rounded(cv::Point2d position, double zoom);

}  // namespace morphkit::edit
