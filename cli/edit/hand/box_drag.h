#pragma once
// A box over a picture that selects what lies in it: vertices with the mesh tool, features with the others.

#include "cli/edit/hand/drag.h"

namespace morphkit::edit {

/// Owns the sketch of the model. With Shift the box adds to the selection.
class BoxDrag : public PictureDrag {
 public:
  BoxDrag(ToolContext& context, const Press& press);
  void release(const Mouse& mouse) override;

 protected:
  void follow(const Mouse& mouse, cv::Point2d now) override;
};

}  // namespace morphkit::edit
