#pragma once
// Maps positions from one picture to the other by the current warp. Internal to cli/edit.

#include <span>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/evaluate.h"

namespace morphkit::edit {

/// The positions in the other picture that correspond to positions in `side`'s picture, clamped to the other picture:
/// where render::Warper::carry puts them, else under the same canvas pixel.
/// @param moments  of the project. @param sizes  of the pictures, px, in their order. @param positions  finite.
/// Cost: O(lines) or O(vertices) for each position.
std::vector<cv::Point2d> counterparts(const project::Project& project, const project::Evaluator& moments,
                                      std::span<const cv::Size> sizes, project::SideIndex side,
                                      std::span<const cv::Point2d> positions);

/// The vertices of a mesh on a picture of that size, px; computed if the mesh is uniform and lists none.
project::Points vertices_on(cv::Size picture, int columns, int rows, const project::Points& listed);

}  // namespace morphkit::edit
