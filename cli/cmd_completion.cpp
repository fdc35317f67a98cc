#include "cli/cmd_completion.h"

#include <memory>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/completion_script.h"
#include "cli/exit_code.h"
#include "cli/terminal.h"

namespace morphkit::cli {

void add_completion(CommandLine& line, Session& session) {
  auto options = std::make_shared<CompletionOptions>();
  Options command =
      add_command(line, session,
                  {"completion", "Print a script that completes commands and options in your shell",
                   "  source <(morphkit completion bash)        # this shell; put it into ~/.bashrc for all\n"
                   "  source <(morphkit completion zsh)\n"
                   "  morphkit completion fish > ~/.config/fish/completions/morphkit.fish",
                   kHelpGroup},
                  [&line, options](Output& output) { return run_completion(*options, line.shape(), output); });
  command.choice("SHELL", options->shell, "Which shell", "", {"bash", "zsh", "fish"}).required();
}

int run_completion(const CompletionOptions& options, const CommandShape& program, Output& output) {
  if (options.shell == "bash") {
    output.print(bash_completion(program));
  } else if (options.shell == "zsh") {
    output.print(zsh_completion(program));
  } else if (options.shell == "fish") {
    output.print(fish_completion(program));
  } else {
    throw ArgumentError("completion", fmt::format("unknown shell {}; bash, zsh or fish", options.shell));
  }
  return 0;
}

}  // namespace morphkit::cli
