#pragma once
// SIGINT, SIGTERM and SIGHUP ask the program to stop cleanly; a second one, half a second later or more,
// stops it at once.

#include <string>

namespace morphkit::cli {

/// Installs the handlers. A signal that the caller ignores (nohup, a shell's background job) stays ignored.
void install_interrupt_handlers();

/// Whether one of the signals has arrived. Thread-safe.
bool interrupted() noexcept;

/// @throws Error kInterrupted if one of the signals has arrived. @param what  the state of the work: "nothing was
/// written".
void stop_if_interrupted(const std::string& what);

}  // namespace morphkit::cli
