#pragma once
// The window. The only file that uses highgui.

namespace morphkit::edit {

class Editor;

/// Runs the event loop until the editor is done or the program is interrupted.
/// @throws Error kFailed if there is no display; kInterrupted after a signal, with unsaved changes in the autosave.
void run_window(Editor& editor);

/// @throws Error kFailed if there is no display. Cheap: call before anything is loaded.
void require_display();

}  // namespace morphkit::edit
