#pragma once
// The program: its commands, and how results and errors become messages and an exit code.

#include "cli/command_shape.h"

namespace morphkit::cli {

struct Works;

/// Runs one command line.
/// @return  the exit code; see docs/commands.md. No exception leaves.
/// @param works  what needs picture libraries; null: another program does it, see works.h.
int run_program(int argc, const char* const* argv, const Works* works) noexcept;

/// The commands and options of the program.
CommandShape program_shape();

}  // namespace morphkit::cli
