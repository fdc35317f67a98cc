#pragma once
// Lint for meshes. Internal to morph/render.

#include <vector>

#include "morph/render/check.h"

namespace morphkit::render {

/// Vertices out of order on either side and in between, and parts that the passes squeeze.
void check_mesh(const Renderer& renderer, std::vector<Finding>& findings);

/// The vertex that is nearest to a canvas position at a moment.
cv::Point nearest_vertex(const Renderer& renderer, cv::Point2d position, project::Time time);

}  // namespace morphkit::render
