#include "cli/edit/hand/line_tool.h"

#include <utility>

#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

/// Owns the sketch of the model. A click makes no line and deselects.
class LineDrag : public PictureDrag {
 public:
  LineDrag(ToolContext& context, const Press& press, cv::Point2d at) : PictureDrag(context, press) {
    context.model().sketch = Sketch{Sketch::Shape::kLine, side_of(press.pane), {at, at}, at};
  }

  void release(const Mouse& mouse) override {
    Model& model = context().model();
    const Sketch sketch = *std::exchange(model.sketch, std::nullopt);
    if (is_click(mouse.position)) return context().select({});
    const int feature = model.document.add_line(sketch.side, sketch.points[0], sketch.points[1]);
    if (feature < 0) return;
    model.held = Handle{other(sketch.side), feature, 1, -1};
    tell_of_new_mark(context());
  }

 protected:
  void follow(const Mouse& mouse, cv::Point2d now) override {
    context().model().sketch->points.back() = context().snapped(side_of(press().pane), now, mouse, -1);
  }
};

}  // namespace

std::unique_ptr<Drag> LineTool::begin(const Press& press, cv::Point2d at) {
  return std::make_unique<LineDrag>(context(), press, at);
}

}  // namespace morphkit::edit
