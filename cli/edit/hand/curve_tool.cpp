#include "cli/edit/hand/curve_tool.h"

#include <utility>

#include "cli/edit/view/picking.h"

namespace morphkit::edit {

std::unique_ptr<Drag> CurveTool::press(const Press& press) {
  if (press.again) {
    end(false);
  } else if (drawing()) {
    add_click(press);
  } else {
    return DrawingTool::press(press);
  }
  return nullptr;
}

std::unique_ptr<Drag> CurveTool::begin(const Press& press, cv::Point2d at) {
  model().sketch = Sketch{Sketch::Shape::kCurve, side_of(press.pane), {at}, at};
  context().say("click along the curve; Enter ends it, its first point closes it");
  return nullptr;
}

void CurveTool::add_click(const Press& press) {
  Sketch& sketch = *model().sketch;
  if (sketch.side != side_of(press.pane)) return end(false);
  const double reach = context().reach(press.pane, kHandleReach);
  if (sketch.points.size() > 2 && length(press.content - sketch.points.front()) <= reach) return end(true);
  sketch.next = context().snapped(sketch.side, press.content, press.mouse, -1);
  sketch.points.push_back(sketch.next);
}

void CurveTool::hover(const Mouse& mouse) {
  if (!drawing()) return;
  Sketch& sketch = *model().sketch;
  const Pane pane = pane_of(sketch.side);
  if (context().panes().pane_at(mouse.position) != pane) return;
  sketch.next = context().snapped(sketch.side, context().content_at(pane, mouse.position), mouse, -1);
}

bool CurveTool::perform(Command command) {
  if (!drawing()) return false;
  switch (command) {
    case Command::kEndCurve:
      end(false);
      return true;
    case Command::kErase:
    case Command::kUndo:
      take_back_click();
      return true;
    case Command::kEscape:
      drop();
      return true;
    case Command::kRedo:
      return true;
    default:
      return false;
  }
}

void CurveTool::take_back_click() {
  model().sketch->points.pop_back();
  if (model().sketch->points.empty()) drop();
}

void CurveTool::drop() {
  model().sketch.reset();
  model().snapped.reset();
  model().held.reset();
}

void CurveTool::end(bool closed) {
  if (!drawing()) return;
  const Sketch sketch = *std::exchange(model().sketch, std::nullopt);
  model().snapped.reset();
  const int feature = document().add_curve(sketch.side, sketch.points, closed);
  if (feature < 0) return context().say("too few points for a curve");
  tell_of_new_mark(context());
}

}  // namespace morphkit::edit
