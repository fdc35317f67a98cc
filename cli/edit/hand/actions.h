#pragma once
// Performs the actions of keys and buttons.

#include <optional>

#include "cli/edit/hand/input.h"
#include "cli/edit/hand/playback.h"
#include "cli/edit/hand/text_entry.h"
#include "cli/edit/hand/tool_context.h"
#include "cli/edit/hand/toolbox.h"
#include "cli/edit/view/actions.h"

namespace morphkit::edit {

/// Has no state of its own. The others outlive it.
class Actions {
 public:
  Actions(ToolContext& context, Toolbox& tools, TextEntry& entry, Playback& playback)
      : context_(context), tools_(tools), entry_(entry), playback_(playback) {}

  /// Sliders do nothing here: they are dragged.
  std::optional<EditorRequest> perform(const Action& action);

 private:
  std::optional<EditorRequest> perform_command(Command command);
  void perform_other(Command command);  ///< commands of no tool and on no mark

  void perform_value(ToolId tool) { tools_.choose(tool); }
  void perform_value(Show show) { context_.model().show = show; }
  void perform_value(Toggle toggle);
  void perform_value(Nudge by);
  void perform_value(StepFrames step) { playback_.step(step.frames); }
  void perform_value(GoTo moment) { playback_.go_to(moment.t); }
  void perform_value(TimingKind which);
  void perform_value(Answer answer) { context_.model().answer = answer.key; }
  void perform_value(TimeSlider) {}
  void perform_value(Tuning) {}

  ToolContext& context_;
  Toolbox& tools_;
  TextEntry& entry_;
  Playback& playback_;
};

}  // namespace morphkit::edit
