#include "cli/cmd_help.h"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "base/words.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/command_shape.h"
#include "cli/exit_code.h"
#include "cli/man_page.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

struct HelpOptions {
  std::string command;
  bool man = false;
};

/// The page of the program points to those of all commands, and they to it.
std::string man_page(const CommandLine& line, const std::string& command, const std::string& help) {
  const CommandShape program = line.shape();
  ManPage page{command.empty() ? program.name : program.name + " " + command, MORPHKIT_VERSION, help, {program.name}};
  if (command.empty()) {
    page.see_also.clear();
    for (const std::string& name : command_names(program)) page.see_also.push_back(program.name + " " + name);
  }
  return to_roff(page);
}

int run_help(const CommandLine& line, const HelpOptions& options, Output& output) {
  const std::string& command = options.command;
  const std::optional<std::string> text = line.help(command);
  if (!text) {
    const auto similar = nearest(command, command_names(line.shape()));
    throw ArgumentError("help", fmt::format("unknown command '{}'{}", command,
                                            similar ? fmt::format("; did you mean '{}'?", *similar) : ""));
  }
  output.print(options.man ? man_page(line, command, *text) : *text);
  return 0;
}

}  // namespace

void add_help(CommandLine& line, Session& session) {
  auto options = std::make_shared<HelpOptions>();
  const std::vector<std::string> commands = command_names(line.shape());
  Options command =
      add_command(line, session, {"help", "Print the help of a command", "  morphkit help compare", kHelpGroup},
                  [&line, options](Output& output) { return run_help(line, *options, output); });
  command.text("COMMAND", options->command, "Which; all if left out",
               fmt::format("{{{},help}}", fmt::join(commands, ",")));
  command.flag("--man", options->man, "Print a manual page in roff: morphkit help --man morph | man -l -");
}

}  // namespace morphkit::cli
