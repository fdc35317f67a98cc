#include "cli/cmd_completion.h"

#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/command.h"
#include "cli/completion_script.h"
#include "cli/terminal.h"

namespace morphkit::cli {

void add_completion(CLI::App& app, Session& session) {
  CLI::App* command =
      add_command(app, session,
                  {"completion", "Print a script that completes commands and options in your shell",
                   "  source <(morphkit completion bash)        # this shell; put it into ~/.bashrc for all\n"
                   "  source <(morphkit completion zsh)\n"
                   "  morphkit completion fish > ~/.config/fish/completions/morphkit.fish",
                   kHelpGroup});
  auto options = std::make_shared<CompletionOptions>();
  command->add_option("SHELL", options->shell, "Which shell")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&app, &session, options] {
    session.action = [&app, options](Output& output) { return run_completion(*options, shape_of(app), output); };
  });
}

int run_completion(const CompletionOptions& options, const CommandShape& program, Output& output) {
  if (options.shell == "bash") {
    output.print(bash_completion(program));
  } else if (options.shell == "zsh") {
    output.print(zsh_completion(program));
  } else if (options.shell == "fish") {
    output.print(fish_completion(program));
  } else {
    throw Error(ErrorCode::kUsage, "completion", fmt::format("unknown shell {}; bash, zsh or fish", options.shell));
  }
  return 0;
}

}  // namespace morphkit::cli
