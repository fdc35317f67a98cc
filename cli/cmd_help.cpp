#include "cli/cmd_help.h"

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/words.h"
#include "cli/command.h"
#include "cli/command_shape.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

int run_help(const CLI::App& app, const std::string& name, Output& output) {
  if (name.empty()) {
    // App::help() would print the help of the command that was parsed: this one.
    output.print(app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
    return 0;
  }
  const auto named = app.get_subcommands([&name](const CLI::App* command) { return command->check_name(name); });
  if (named.empty()) {
    const auto similar = nearest(name, command_names(shape_of(app)));
    throw Error(
        ErrorCode::kUsage, "help",
        fmt::format("unknown command '{}'{}", name, similar ? fmt::format("; did you mean '{}'?", *similar) : ""));
  }
  output.print(named.front()->help(app.get_name()));
  return 0;
}

}  // namespace

void add_help(CLI::App& app, Session& session) {
  CLI::App* command =
      add_command(app, session, {"help", "Print the help of a command", "  morphkit help compare", kHelpGroup});
  auto name = std::make_shared<std::string>();
  command->add_option("COMMAND", *name, "Which; all if left out")
      ->type_name(fmt::format("{{{}}}", fmt::join(command_names(shape_of(app)), ",")));
  command->callback([&app, &session, name] {
    session.action = [&app, name](Output& output) { return run_help(app, *name, output); };
  });
}

}  // namespace morphkit::cli
