#pragma once
// The program: its commands, and how what happens becomes messages and an exit code.

#include <memory>

#include "cli/command_shape.h"

namespace morphkit::cli {

/// Runs one command line.
/// @return  the exit code; see docs/commands.md. No exception leaves.
int run_program(int argc, const char* const* argv) noexcept;

/// The commands and options of the program.
CommandShape program_shape();

}  // namespace morphkit::cli
