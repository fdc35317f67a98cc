#include "cli/command.h"

#include <CLI/CLI.hpp>

#include "cli/help_format.h"

namespace morphkit::cli {

void add_common_options(CLI::App& app, CommonOptions& common) {
  app.get_help_ptr()->group(kCommonGroup);
  app.add_flag("-q,--quiet", common.quiet, "Print results, warnings and errors only")->group(kCommonGroup);
  app.add_flag("-v,--verbose", common.verbose, "Tell more about what is done; --quiet wins")->group(kCommonGroup);
  app.add_option("-j,--threads", common.threads, "Threads to use; 0: all. The result never depends on it")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""))
      ->group(kCommonGroup);
}

CLI::App* add_command(CLI::App& app, Session& session, const CommandText& text) {
  CLI::App* command = app.add_subcommand(text.name, text.summary);
  command->group(text.group);
  command->footer("Example:\n" + text.examples);
  add_common_options(*command, session.common);
  return command;
}

}  // namespace morphkit::cli
