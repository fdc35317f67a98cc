#pragma once
// Marks on the panes: features, meshes, what is being drawn. Pictures are those of a pane alone.

#include <vector>

#include <opencv2/core.hpp>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/text.h"
#include "morph/render/inbetween.h"

namespace morphkit::edit {

/// On a picture: features or mesh, the sketch, what it has snapped to.
void draw_marks(cv::Mat3b& pane, const Model& model, SideIndex side, double scale, const Type& type);

/// On the result: the in-between lines of the moment, or of five with the onion skin.
void draw_between(cv::Mat3b& pane, const Model& model, const std::vector<render::LinePair>& pairs, double scale);

}  // namespace morphkit::edit
