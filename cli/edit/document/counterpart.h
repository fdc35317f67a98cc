#pragma once
// Carries a position from one picture to the other by the warp so far. Internal to cli/edit.

#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/evaluate.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

/// The position in the other picture that corresponds to a position in `side`'s picture, clamped to the other picture.
/// With features, the field of all of them gives it. With a mesh, the two triangles of each cell give it; a render's
/// spline agrees with them only at the vertices, but this is good enough for a first guess. Without either, it is the
/// position under the same canvas pixel.
/// @param moment  of the project. @param source, destination  sizes of the pictures, px.
/// @param position  finite. Cost: O(lines) or O(vertices).
cv::Point2d counterpart(const project::Project& project, const project::Moment& moment, cv::Size source,
                        cv::Size destination, project::SideIndex side, cv::Point2d position);

/// The vertices of a mesh on one picture of that size, px, also if it is uniform and so lists none.
project::Points vertices_on(cv::Size picture, int columns, int rows, const project::Points& listed);

}  // namespace morphkit::edit
