#include "cli/edit/hand/tool.h"

#include <fmt/format.h>

#include "cli/edit/hand/box_drag.h"
#include "cli/edit/hand/mark_drag.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::unique_ptr<Drag> DrawingTool::press(const Press& press) {
  const auto hit = hit_test(model(), context().panes(), press.mouse.position);
  if (hit && !press.mouse.ctrl) return press_mark(context(), press, *hit);
  if (press.again) {
    model().fit_views();
    return nullptr;
  }
  model().switches.features = true;
  if (press.mouse.shift) return std::make_unique<BoxDrag>(context(), press);
  return begin(press, context().snapped(side_of(press.pane), press.content, press.mouse, -1));
}

void tell_of_new_mark(const ToolContext& context) {
  const bool idle = context.document().method() == project::MethodName::kMesh;
  context.say(fmt::format(
      "{}: {}", context.document().project().features.back().id,
      idle ? "does nothing while the mesh warps; \"Warp: mesh\" below changes that" : "put its partner right"));
}

}  // namespace morphkit::edit
