#pragma once
// Lint for a morph: what will tear, fold or be lost, found before anybody renders it.

#include <vector>

#include "morph/render/finding.h"
#include "morph/render/renderer.h"

namespace morphkit::render {

/// The problems of kMoments, each once, as it is at its worst. Cost: five times Warper::problems().
std::vector<Finding> check(const Renderer& renderer);

}  // namespace morphkit::render
