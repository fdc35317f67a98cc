#pragma once
// Lint for a morph: finds what will tear, fold or be lost before it is rendered.

#include <vector>

#include "morph/render/finding.h"
#include "morph/render/renderer.h"

namespace morphkit::render {

/// The problems at kMoments; of equal ones, the worst. Cost: five times Warper::problems().
std::vector<Finding> check(const Renderer& renderer);

}  // namespace morphkit::render
