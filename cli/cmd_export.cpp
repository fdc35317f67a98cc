#include "cli/cmd_export.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_export(CommandLine& line, Session& session) {
  auto options = std::make_shared<ExportOptions>();
  Options command = add_command(line, session,
                                {"export", "Write a project's mesh for other tools (xmorph and gtkmorph)",
                                 "  morphkit export pair.json cat.mesh tiger.mesh", kRenderGroup},
                                work_of(session, &Works::export_, options));
  command.path("PROJECT", options->project, "The project file", "").required();
  command.paths("FILE", options->files, "The files to write, the source's first: two .mesh", "").required();
  declare_changes(command, options->changes);
  command.flag("-y,--overwrite", options->overwrite, "Replace files that exist");
}

}  // namespace morphkit::cli
