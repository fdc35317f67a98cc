#include "cli/cmd_schema.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/terminal.h"
#include "morph/project/project.h"

namespace morphkit::cli {

void add_schema(CLI::App& app, Session& session) {
  CLI::App* command =
      add_command(app, session,
                  {"schema", "Print the JSON Schema of project files, for editors and validators",
                   "  morphkit schema > morphkit.schema.json\n"
                   "  # then, in an editor that knows JSON Schema, complete and check pair.json as you type",
                   kHelpGroup});
  command->callback([&session] { session.action = [](Output& output) { return run_schema(output); }; });
}

int run_schema(Output& output) {
  const std::string text = project::schema_text();
  output.print(text);
  if (!text.ends_with('\n')) output.print("\n");
  return 0;
}

}  // namespace morphkit::cli
