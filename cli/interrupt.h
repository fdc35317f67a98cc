#pragma once
// SIGINT, SIGTERM and SIGHUP ask the program to stop cleanly; a second one stops it at once.

namespace morphkit::cli {

/// Installs the handlers. A signal that the caller had ignored (nohup, a shell's background job) stays ignored.
void install_interrupt_handlers();

/// Whether one of the signals has arrived. Any thread, any time.
bool interrupted() noexcept;

}  // namespace morphkit::cli
