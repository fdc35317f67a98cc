#pragma once
// Commands on what is selected, and undo.

#include "cli/edit/hand/tool_context.h"
#include "cli/edit/view/actions.h"

namespace morphkit::edit {

/// @return false: not a command of this kind.
bool perform_on_marks(const ToolContext& context, Command command);

/// Moves the held point alone, if nothing else is selected; else everything that is selected.
void nudge(const ToolContext& context, Nudge by);

/// Gives a timing of the selection or the project the next easing.
void use_next_easing(Document& document, TimingKind which);

}  // namespace morphkit::edit
