#pragma once

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Draws curves click by click. Its state is the sketch of the model, which lasts from click to click.
class CurveTool : public DrawingTool {
 public:
  using DrawingTool::DrawingTool;
  std::unique_ptr<Drag> press(const Press& press) override;
  void hover(const Mouse& mouse) override;
  /// While a curve is drawn: Enter ends it, Esc drops it, undo and delete take back the last click, redo does nothing.
  bool perform(Command command) override;
  void leave() override { end(false); }

 protected:
  std::unique_ptr<Drag> begin(const Press& press, cv::Point2d at) override;

 private:
  bool drawing() const { return model().sketch && model().sketch->shape == Sketch::Shape::kCurve; }
  void add_click(const Press& press);
  void take_back_click();
  void drop();
  void end(bool closed);
};

}  // namespace morphkit::edit
