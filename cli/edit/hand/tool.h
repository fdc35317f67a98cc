#pragma once
// The interface of a tool. One class per tool, one row of kTools (actions.h) and one line of toolbox.cpp.

#include <memory>

#include "cli/edit/hand/drag.h"
#include "cli/edit/view/actions.h"

namespace morphkit::edit {

class Tool {
 public:
  explicit Tool(ToolContext& context) : context_(context) {}
  virtual ~Tool() = default;

  /// The left button is pressed on a picture.
  /// @return the drag that this begins; null if nothing is dragged.
  virtual std::unique_ptr<Drag> press(const Press& press) = 0;

  /// The mouse moves over the canvas without a drag.
  virtual void hover(const Mouse&) {}

  /// A key or a button. @return whether the tool has handled it.
  virtual bool perform(Command) { return false; }

  /// Another tool is chosen: finishes what is being drawn.
  virtual void leave() {}

 protected:
  ToolContext& context() const { return context_; }
  Model& model() const { return context_.model(); }
  Document& document() const { return context_.document(); }

 private:
  ToolContext& context_;
};

/// A tool that draws marks. A press grabs a mark, a Shift press drags a box; any other press, and any press with Ctrl,
/// begins a mark.
class DrawingTool : public Tool {
 public:
  using Tool::Tool;
  std::unique_ptr<Drag> press(const Press& press) override;

 protected:
  /// @param at  picture px, snapped.
  virtual std::unique_ptr<Drag> begin(const Press& press, cv::Point2d at) = 0;
};

/// Shows a message about the new mark.
void tell_of_new_mark(const ToolContext& context);

}  // namespace morphkit::edit
