#pragma once
// What lies over everything: the help, the welcome, a question, the loupe.

#include <opencv2/core.hpp>

#include "cli/edit/layout.h"
#include "cli/edit/model.h"
#include "cli/edit/pyramid.h"
#include "cli/edit/text.h"

namespace morphkit::edit {

void draw_help(cv::Mat3b& canvas, const Layout& layout, const Type& type);
void draw_welcome(cv::Mat3b& canvas, const Layout& layout, const Type& type);
void draw_question(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Type& type);

/// At the mouse, if it is on a picture.
void draw_loupe(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Pyramid& source,
                const Pyramid& destination);

}  // namespace morphkit::edit
