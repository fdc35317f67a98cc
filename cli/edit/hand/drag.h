#pragma once
// Drags: what the mouse does from a press to its release. A drag lives that long and owns the state of it.

#include <opencv2/core/types.hpp>

#include "cli/edit/hand/tool_context.h"

namespace morphkit::edit {

/// A press on a pane.
struct Press {
  Mouse mouse;
  bool again = false;  ///< the second press of a double-click
  Pane pane = Pane::kSource;
  cv::Point2d content;  ///< px of the content of the pane
};

class Drag {
 public:
  virtual ~Drag() = default;
  /// The mouse has moved.
  virtual void move(const Mouse& mouse) = 0;
  /// The button is up. Not called for a drag that Esc has cancelled.
  virtual void release(const Mouse& mouse) = 0;
};

/// A drag on a picture. It begins when the mouse has moved further than in a click.
class PictureDrag : public Drag {
 public:
  PictureDrag(ToolContext& context, const Press& press) : context_(context), press_(press) {}
  void move(const Mouse& mouse) final;

 protected:
  /// @param now  picture px of the side of the press.
  virtual void follow(const Mouse& mouse, cv::Point2d now) = 0;

  ToolContext& context() const { return context_; }
  const Press& press() const { return press_; }
  bool moved() const { return moved_; }
  /// Whether a release at a canvas position counts as a click.
  bool is_click(cv::Point position) const;

 private:
  ToolContext& context_;
  Press press_;
  bool moved_ = false;
};

}  // namespace morphkit::edit
