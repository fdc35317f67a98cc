#pragma once
// The window: the only file that knows highgui.

namespace morphkit::edit {

class Editor;

/// Shows the editor until it is done or the program is interrupted.
/// @throws Error kFailed if there is no display to show it on; kInterrupted after a signal, with the work rescued.
void run_window(Editor& editor);

/// @throws Error kFailed if there is no display. Cheap: call before anything is loaded.
void require_display();

}  // namespace morphkit::edit
