#include "cli/cmd_check.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_check(CommandLine& line, Session& session) {
  auto options = std::make_shared<CheckOptions>();
  Options command = add_command(
      line, session,
      {"check", "Look for crossing lines, near-twins, marks outside their picture and folds; exit code 5 if any",
       "  morphkit check pair.json\n"
       "  morphkit check pair.json --json",
       kInspectGroup},
      work_of(session, &Works::check, options));
  declare_project(command, options->project);
  command.flag("--json", options->json, "Print the findings as JSON");
}

}  // namespace morphkit::cli
