#pragma once
// Draws marks on panes: features, meshes, sketches. Each picture is one pane.

#include <vector>

#include <opencv2/core.hpp>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/text.h"
#include "morph/render/inbetween.h"

namespace morphkit::edit {

/// On a picture: features or mesh, the sketch, the snap target.
void draw_marks(cv::Mat3b& pane, const Model& model, SideIndex side, double scale, const Type& type);

/// On the result: the in-between lines at t, with the onion skin also at five moments.
void draw_between(cv::Mat3b& pane, const Model& model, const std::vector<render::LinePair>& pairs, double scale);

}  // namespace morphkit::edit
