#pragma once
// Lint for feature lines. Internal to morph/render.

#include <string>
#include <vector>

#include "morph/render/finding.h"
#include "morph/render/inbetween.h"
#include "morph/render/stage.h"

namespace morphkit::render {

/// Crossings, twins, marks outside their picture. @param lines  of the moment's features, on the whole canvas.
/// Cost: lines^2.
std::vector<Finding> line_problems(const project::Moment& moment, const std::vector<FeatureLine>& lines,
                                   const Stage& stage);

/// Ids of the three features that are nearest to a canvas position.
std::vector<std::string> nearest_features(const project::Moment& moment, const std::vector<FeatureLine>& lines,
                                          cv::Point2d position);

}  // namespace morphkit::render
