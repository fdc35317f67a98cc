#include "cli/cmd_map.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_map(CommandLine& line, Session& session) {
  auto options = std::make_shared<MapOptions>();
  Options command = add_command(line, session,
                                {"map", "Write the map of a moment as an STMap (32-bit float EXR) for any compositor",
                                 "  morphkit map pair.json -t 0.5 -o stmap.exr\n"
                                 "  morphkit map pair.json --frames 1-48 --side destination -o stmap.%04d.exr",
                                 kRenderGroup},
                                work_of(session, &Works::map, options));
  declare_project(command, options->project, {KeyOption::kField});
  command.real("-t,--time", options->t, "The moment, 0 (source) to 1 (destination)", "T");
  command.text("--frames", options->frames, "Or these frames, into numbered files", "RANGE");
  command.choice("--side", options->side, "Which picture the map looks into: source (default), destination", "SIDE",
                 {"source", "destination"});
  command.choice("--origin", options->origin, "Where (0, 0) lies: bottom-left (default), top-left", "CORNER",
                 {"bottom-left", "top-left"});
  command.path("-o,--output", options->output, "The file, or a numbered name for frames", "OUT.exr").required();
  command.flag("--allow-folds", options->allow_folds, "Write the map of a mesh that folds over all the same");
  command.flag("-y,--overwrite", options->overwrite, "Replace files that exist");
}

}  // namespace morphkit::cli
