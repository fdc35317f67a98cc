#include "cli/edit/hand/point_tool.h"

#include "cli/edit/hand/mark_drag.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::unique_ptr<Drag> PointTool::begin(const Press& press, cv::Point2d at) {
  const SideIndex side = side_of(press.pane);
  document().begin();
  const int feature = document().add_point(side, at);
  if (feature < 0) {
    document().end();
    return nullptr;
  }
  const Handle handle{side, feature, 0, -1};
  model().held = handle;
  tell_of_new_mark(context());
  return std::make_unique<PointDrag>(context(), press, handle);
}

}  // namespace morphkit::edit
