#include "cli/cmd_edit.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_edit(CommandLine& line, Session& session) {
  auto options = std::make_shared<EditOptions>();
  Options command = add_command(line, session,
                                {"edit", "Mark features on two pictures in a window, and watch the morph change",
                                 "  morphkit edit a.jpg b.jpg                 # saves to a-b.json\n"
                                 "  morphkit edit pair.json\n"
                                 "  morphkit edit a.jpg b.jpg -o pair.json --window 1920x1000",
                                 kRenderGroup},
                                work_of(session, &Works::edit, options));
  declare_project(command, options->project);
  command.path("-o,--output", options->output, "The project file for two pictures (default: A-B.json)", "FILE");
  command.text("--window", options->window, "Size of the window (default: 1600x900)", "WxH");
}

}  // namespace morphkit::cli
