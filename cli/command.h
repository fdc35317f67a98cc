#pragma once
// What all commands share: the common options and how a command enters the program.

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace morphkit::cli {

class Output;

/// Options that every command takes.
struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  int threads = 0;  ///< 0: all that the machine has
};

/// One run of the program: what the command line asks for.
struct Session {
  CommonOptions common;
  /// Set by the command that was named; returns the exit code. Runs after the whole command line has been understood.
  std::function<int(Output&)> action;
};

/// The texts of a command.
struct CommandText {
  std::string name;
  std::string summary;   ///< one line, in the list of commands
  std::string examples;  ///< lines of command line, each "  morphkit ...", comments allowed
  std::string group;     ///< heading in the list of commands: kRenderGroup, ...
};

inline constexpr const char* kRenderGroup = "Make";
inline constexpr const char* kInspectGroup = "Look";
inline constexpr const char* kHelpGroup = "Start and help";

/// Exit code of commands that found a difference or a fault in what they were asked to judge.
inline constexpr int kExitDifference = 5;

/// Adds a command with the common options and its examples below the help.
CLI::App* add_command(CLI::App& app, Session& session, const CommandText& text);

/// Adds the common options to the program or a command.
void add_common_options(CLI::App& app, CommonOptions& common);

}  // namespace morphkit::cli
