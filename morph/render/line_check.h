#pragma once
// Lint for feature lines. Internal to morph/render.

#include <string>
#include <vector>

#include "morph/render/check.h"

namespace morphkit::render {

/// Crossings, twins, marks outside their picture. Cost: lines^2.
void check_lines(const Renderer& renderer, std::vector<Finding>& findings);

/// Ids of the three features that are nearest to a canvas position at a moment.
std::vector<std::string> nearest_features(const Renderer& renderer, cv::Point2d position, project::Time time);

}  // namespace morphkit::render
