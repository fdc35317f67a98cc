#pragma once
// Lint for meshes. Internal to morph/render.

#include <optional>
#include <vector>

#include "morph/render/finding.h"
#include "morph/render/mesh_warper.h"

namespace morphkit::render {

/// Vertices out of order on the pictures and in between.
std::vector<Finding> mesh_folds(const std::vector<MeshSide>& sides, const warp::Mesh& between, double t);

/// Where the passes squeeze a picture on its way to the in-between mesh; nothing if that is not visible.
std::optional<Finding> bottleneck(SideIndex side, const MeshPasses& passes);

/// The vertex that is nearest to a position.
cv::Point nearest_vertex(const warp::Mesh& mesh, cv::Point2d position);

}  // namespace morphkit::render
