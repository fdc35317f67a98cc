#include "cli/cmd_help.h"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "base/error.h"
#include "base/words.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/command_shape.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

int run_help(const CommandLine& line, const std::string& command, Output& output) {
  const std::optional<std::string> text = line.help(command);
  if (!text) {
    const auto similar = nearest(command, command_names(line.shape()));
    throw Error(
        ErrorCode::kUsage, "help",
        fmt::format("unknown command '{}'{}", command, similar ? fmt::format("; did you mean '{}'?", *similar) : ""));
  }
  output.print(*text);
  return 0;
}

}  // namespace

void add_help(CommandLine& line, Session& session) {
  auto name = std::make_shared<std::string>();
  const std::vector<std::string> commands = command_names(line.shape());
  Options command =
      add_command(line, session, {"help", "Print the help of a command", "  morphkit help compare", kHelpGroup},
                  [&line, name](Output& output) { return run_help(line, *name, output); });
  command.text("COMMAND", *name, "Which; all if left out", fmt::format("{{{},help}}", fmt::join(commands, ",")));
}

}  // namespace morphkit::cli
