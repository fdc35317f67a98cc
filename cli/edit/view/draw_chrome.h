#pragma once
// Draws the strips around the panes: widgets, titles, the status line.

#include <opencv2/core.hpp>

#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/preview.h"
#include "cli/edit/view/text.h"

namespace morphkit::edit {

/// Height of ordinary type, in units of Panes::scale.
inline constexpr double kTypeHeight = 14;

void draw_chrome(cv::Mat3b& canvas, const Model& model, const Layout& layout, const PreviewPicture& preview,
                 const Type& type);

void draw_widget(cv::Mat3b& canvas, const Widget& widget, const Layout& layout, const Model& model, const Type& type);

}  // namespace morphkit::edit
