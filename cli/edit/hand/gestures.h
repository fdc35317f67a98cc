#pragma once
// Turns input into changes of the model: finds the receiver of an event.

#include <memory>
#include <optional>

#include "cli/edit/hand/actions.h"
#include "cli/edit/hand/drag.h"
#include "cli/edit/hand/input.h"
#include "cli/edit/hand/playback.h"
#include "cli/edit/hand/text_entry.h"
#include "cli/edit/hand/tool_context.h"
#include "cli/edit/hand/toolbox.h"
#include "cli/edit/view/layout.h"

namespace morphkit::edit {

/// Owns the tools and the current drag. The model outlives it.
class Gestures {
 public:
  Gestures(Model& model, EdgeFinder edges);
  Gestures(const Gestures&) = delete;
  Gestures& operator=(const Gestures&) = delete;

  std::optional<EditorRequest> mouse(const Mouse& mouse);
  std::optional<EditorRequest> key(int key);
  /// Time passes; playing goes on.
  void tick(double seconds) { playback_.tick(seconds); }

 private:
  std::optional<EditorRequest> press(const Mouse& mouse, bool again);
  std::optional<EditorRequest> press_widget(const Widget& widget, cv::Point position);
  void press_pane(const Press& press);
  void move(const Mouse& mouse);
  void release(const Mouse& mouse);
  std::optional<EditorRequest> press_key(int key);
  void cancel_drag();
  void update_hover();
  Model& model() const { return context_.model(); }

  ToolContext context_;
  Toolbox tools_;
  TextEntry entry_;
  Playback playback_;
  Actions actions_;
  std::unique_ptr<Drag> drag_;  ///< null: the button is up
};

}  // namespace morphkit::edit
