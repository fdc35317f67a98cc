#include "cli/cmd_schema.h"

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/terminal.h"
#include "morph/project/project.h"

namespace morphkit::cli {

void add_schema(CommandLine& line, Session& session) {
  add_command(line, session,
              {"schema", "Print the JSON Schema of project files, for editors and validators",
               "  morphkit schema > morphkit.schema.json\n"
               "  # then, in an editor that knows JSON Schema, complete and check pair.json as you type",
               kHelpGroup},
              [](Output& output) { return run_schema(output); });
}

int run_schema(Output& output) {
  const std::string text = project::schema_text();
  output.print(text);
  if (!text.ends_with('\n')) output.print("\n");
  return 0;
}

}  // namespace morphkit::cli
