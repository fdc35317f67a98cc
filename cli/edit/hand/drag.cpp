#include "cli/edit/hand/drag.h"

namespace morphkit::edit {

bool PictureDrag::is_click(cv::Point position) const {
  return length(position - press_.mouse.position) < kClickPx * context_.panes().scale;
}

void PictureDrag::move(const Mouse& mouse) {
  moved_ = moved_ || !is_click(mouse.position);
  if (moved_) follow(mouse, context_.content_at(press_.pane, mouse.position));
}

}  // namespace morphkit::edit
