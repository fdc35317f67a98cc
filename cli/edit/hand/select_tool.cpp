#include "cli/edit/hand/select_tool.h"

#include "cli/edit/hand/box_drag.h"
#include "cli/edit/hand/mark_drag.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::unique_ptr<Drag> SelectTool::press(const Press& press) {
  const auto hit = hit_test(model(), context().panes(), press.mouse.position);
  if (hit) return press_mark(context(), press, *hit);
  if (press.again) {
    model().fit_views();
    return nullptr;
  }
  model().switches.features = true;
  return std::make_unique<BoxDrag>(context(), press);
}

}  // namespace morphkit::edit
