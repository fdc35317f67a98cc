#pragma once
// Where the warp so far carries a position. Internal to cli/edit.

#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

/// Where a position of `side`'s picture lies on the other one, within that picture. By the features as the field of
/// all of them carries it; by the mesh as the two triangles of each cell do, which is where the spline of a render goes
/// through at the vertices only: good enough for a first guess that a hand puts right. Without either, where both
/// pictures, as placed on the canvas, show the same pixel.
/// @param source, destination  sizes of the pictures, px.
/// @param position  finite. Cost: O(lines) or O(vertices).
cv::Point2d counterpart(const project::Project& project, cv::Size source, cv::Size destination, project::SideIndex side,
                        cv::Point2d position);

/// The project's mesh on one picture of that size, px; a uniform one spelled out. Empty without a mesh.
std::vector<cv::Point2d> vertices_on(const project::Project& project, project::SideIndex side, cv::Size picture);

}  // namespace morphkit::edit
