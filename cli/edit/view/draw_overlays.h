#pragma once
// Overlays: help, welcome, questions, loupe.

#include <opencv2/core.hpp>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/pyramid.h"
#include "cli/edit/view/text.h"

namespace morphkit::edit {

void draw_help(cv::Mat3b& canvas, const Layout& layout, const Type& type);
void draw_welcome(cv::Mat3b& canvas, const Layout& layout, const Type& type);
void draw_question(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Type& type);

/// Beside the mouse, if it is on a picture.
void draw_loupe(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Pyramid& source,
                const Pyramid& destination);

}  // namespace morphkit::edit
