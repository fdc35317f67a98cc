#pragma once
// Draws marks on panes: features, meshes, sketches. Each picture is one pane.

#include <functional>
#include <vector>

#include <opencv2/core.hpp>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/text.h"
#include "morph/render/inbetween.h"

namespace morphkit::edit {

/// On a picture: features or mesh, the sketch, the snap target.
void draw_marks(cv::Mat3b& pane, const Model& model, SideIndex side, double scale, const Type& type);

/// The lines of a moment's features, valid until the next call.
using LinesOf = std::function<const std::vector<render::FeatureLine>&(const project::Moment&)>;

/// On the result: the in-between lines at t, with the onion skin also at five moments.
void draw_between(cv::Mat3b& pane, const Model& model, const LinesOf& lines_of, double scale);

}  // namespace morphkit::edit
