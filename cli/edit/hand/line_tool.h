#pragma once

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Draws lines from press to release. No state: the drag has it.
class LineTool : public DrawingTool {
 public:
  using DrawingTool::DrawingTool;

 protected:
  std::unique_ptr<Drag> begin(const Press& press, cv::Point2d at) override;
};

}  // namespace morphkit::edit
