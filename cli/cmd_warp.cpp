#include "cli/cmd_warp.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_warp(CommandLine& line, Session& session) {
  auto options = std::make_shared<WarpOptions>();
  Options command = add_command(line, session,
                                {"warp", "Bend one image onto a mesh",
                                 "  morphkit warp face.png --mesh smile.mesh -o smiling.png\n"
                                 "  morphkit warp face.png --from neutral.mesh --mesh smile.mesh -o smiling.exr\n"
                                 "  morphkit warp woman.png --mesh pair.json -o as-the-man.png",
                                 kRenderGroup},
                                work_of(session, &Works::warp, options));
  command.path("IMAGE", options->image, "The image", "").required();
  command
      .path("--mesh", options->mesh,
            "The mesh to bend onto: an xmorph .mesh file, or the destination's mesh of a project", "M")
      .required();
  command.path("--from", options->from,
               "The mesh that lies on the image: a .mesh file, or the source's mesh of a project (default: that of "
               "the project M, else evenly spaced)",
               "F");
  command.path("-o,--output", options->output, "The bent image", "OUT").required();
  command.path("--intermediate", options->intermediate, "Also write the image between the two passes", "FILE");
  declare_changes(command, options->changes, {KeyOption::kSize, KeyOption::kSpline, KeyOption::kOrder});
  command.text("--depth", options->depth, "Bits of the output: 8, 16, half, float", "DEPTH");
  command.integer("--quality", options->quality, "JPEG and WebP: 1 to 100", "Q", {1, 100});
  command.flag("--allow-folds", options->allow_folds, "Bend as far as that goes where a mesh folds over");
  command.flag("-y,--overwrite", options->overwrite, "Replace files that exist");
}

}  // namespace morphkit::cli
