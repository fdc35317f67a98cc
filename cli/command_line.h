#pragma once
// The command line: its commands, their options and arguments, their help. A facade for CLI11, whose headers cost 20 s
// in every source that includes them: only command_line.cpp and help_format.cpp do.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command_shape.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace morphkit::cli {

class Output;

/// The texts of a command.
struct CommandText {
  std::string name;
  std::string summary;   ///< one line, in the list of commands
  std::string examples;  ///< lines of command line, each "  morphkit ...", comments allowed
  std::string group;     ///< heading in the list of commands: kRenderGroup, ...
};

/// Smallest and largest value that an option takes.
struct Range {
  int least = 0;
  int most = 0;
};

/// The work of a command. @return the exit code.
using Action = std::function<int(Output&)>;

/// An option or argument that has just been declared.
class Option {
 public:
  /// The command line must have it.
  Option& required();
  /// The heading in the help.
  Option& group(const char* heading);

 private:
  friend class Options;
  explicit Option(CLI::Option& option) : option_(&option) {}
  CLI::Option* option_;
};

/// The options and arguments of the program or of one command. Names are "-o,--output" for an option and "IMAGE" for an
/// argument; an argument that holds a list takes what is left. `type` is what the help calls the value. Parsing writes
/// to `value`, which must outlive the command line; a value that is not given stays as it is.
class Options {
 public:
  explicit Options(CLI::App& app) : app_(&app) {}

  Option flag(const char* names, bool& value, const char* help);
  Option text(const char* names, std::string& value, const char* help, const std::string& type);
  /// An option that may be given several times, with one value each.
  Option texts(const char* names, std::vector<std::string>& value, const char* help, const char* type);
  Option integer(const char* names, int& value, const char* help, const char* type, Range range);
  Option integer(const char* names, std::optional<int>& value, const char* help, const char* type, Range range);
  Option real(const char* names, std::optional<double>& value, const char* help, const char* type);
  /// A number of at least 0.
  Option amount(const char* names, double& value, const char* help, const char* type);
  /// One of `words`.
  Option choice(const char* names, std::string& value, const char* help, const char* type,
                const std::vector<std::string>& words);
  Option path(const char* names, std::filesystem::path& value, const char* help, const char* type);
  /// At least one path, and at most `most` if that is not 0.
  Option paths(const char* names, std::vector<std::filesystem::path>& value, const char* help, const char* type,
               int most = 0);

 private:
  CLI::App* app_;
};

/// The command line cannot be understood. what(): the message.
class UsageError : public std::runtime_error {
 public:
  UsageError(const std::string& message, std::string command)
      : std::runtime_error(message), command_(std::move(command)) {}
  /// The command whose help explains more: "morphkit morph".
  const std::string& command() const { return command_; }

 private:
  std::string command_;
};

/// A program with commands.
class CommandLine {
 public:
  /// @param version  what --version prints.
  CommandLine(const char* name, const char* description, const char* version, const char* footer);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  /// The options of the program itself.
  Options options();

  /// Adds a command whose options are still to be declared. @param action  called by whoever runs the program, after
  /// the whole command line has been understood.
  Options add_command(const CommandText& text, Action action);

  /// @return  the action of the command that was named; one that prints the help or the version if that is asked for.
  /// @throws UsageError.
  Action parse(int argc, const char* const* argv);

  /// The help of a command, or of the program if `command` is empty. Nothing if there is no such command.
  std::optional<std::string> help(const std::string& command) const;

  /// All commands and options so far.
  CommandShape shape() const;

 private:
  std::unique_ptr<CLI::App> app_;
  Action action_;  ///< of the command that was parsed
};

}  // namespace morphkit::cli
