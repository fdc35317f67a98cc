#pragma once

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Places points. A drag adjusts the new point in the same step of undo. No state.
class PointTool : public DrawingTool {
 public:
  using DrawingTool::DrawingTool;

 protected:
  std::unique_ptr<Drag> begin(const Press& press, cv::Point2d at) override;
};

}  // namespace morphkit::edit
