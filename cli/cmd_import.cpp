#include "cli/cmd_import.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_import(CommandLine& line, Session& session) {
  auto options = std::make_shared<ImportOptions>();
  Options command =
      add_command(line, session,
                  {"import", "Make a project of other tools' files (xmorph and gtkmorph)",
                   "  morphkit import cat.mesh tiger.mesh --source cat.png --destination tiger.png -o pair.json\n"
                   "  morphkit import faces.session -o pair.json",
                   kRenderGroup},
                  work_of(session, &Works::import_, options));
  command.paths("FILE", options->files, "The other tool's files, the source's first: two .mesh, or one .session", "")
      .required();
  command.path("--source", options->source, "The picture to start from; by default the one that a session names", "A");
  command.path("--destination", options->destination,
               "The picture to arrive at; by default the one that a session names", "B");
  command.path("-o,--output", options->output, "The project to write", "PROJECT").required();
  command.flag("-y,--overwrite", options->overwrite, "Replace the project if it exists");
}

}  // namespace morphkit::cli
