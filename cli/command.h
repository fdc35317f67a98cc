#pragma once
// What all commands share: the common options and how a command enters the program.

#include "cli/command_line.h"

namespace morphkit::cli {

/// Options that every command takes.
struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  int threads = 0;  ///< 0: all that the machine has
};

struct Works;

/// One run of the program.
struct Session {
  CommonOptions common;
  const Works* works = nullptr;  ///< null in the program that starts quickly: see works.h
  const char* const* argv = nullptr;
};

inline constexpr const char* kRenderGroup = "Make";
inline constexpr const char* kInspectGroup = "Look";
inline constexpr const char* kHelpGroup = "Start and help";

/// Adds a command with the common options and its examples below the help.
Options add_command(CommandLine& line, Session& session, const CommandText& text, Action action);

/// Adds the common options to the program or a command.
void add_common_options(Options& options, CommonOptions& common);

}  // namespace morphkit::cli
