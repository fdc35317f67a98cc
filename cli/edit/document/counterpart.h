#pragma once
// Carries a position from one picture to the other by the warp so far. Internal to cli/edit.

#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

/// The position in the other picture that corresponds to a position in `side`'s picture, clamped to the other picture.
/// With features, the field of all of them gives it. With a mesh, the two triangles of each cell give it; a render's
/// spline agrees with them only at the vertices, but this is good enough for a first guess. Without either, it is the
/// position under the same canvas pixel.
/// @param source, destination  sizes of the pictures, px.
/// @param position  finite. Cost: O(lines) or O(vertices).
cv::Point2d counterpart(const project::Project& project, cv::Size source, cv::Size destination, project::SideIndex side,
                        cv::Point2d position);

/// The vertices of the project's mesh on one picture of that size, px, also for a uniform mesh. Empty without a mesh.
std::vector<cv::Point2d> vertices_on(const project::Project& project, project::SideIndex side, cv::Size picture);

}  // namespace morphkit::edit
