#include "cli/cmd_compare.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_compare(CommandLine& line, Session& session) {
  auto options = std::make_shared<CompareOptions>();
  Options command =
      add_command(line, session,
                  {"compare", "Compare two pictures: PSNR, largest difference, worst pixel; exit code 5 if they differ",
                   "  morphkit compare expected.png actual.png\n"
                   "  morphkit compare a.exr b.exr --tolerance 0.004 --difference diff.png --gain 20",
                   kInspectGroup},
                  work_of(session, &Works::compare, options));
  command.path("A", options->a, "A picture", "").required();
  command.path("B", options->b, "Another of the same size", "").required();
  command.amount("--tolerance", options->tolerance, "Largest difference that passes; 1 is black to white", "T");
  command.path("--difference", options->difference, "Write a picture of the difference", "FILE");
  command.amount("--gain", options->gain, "Amplify that picture (10)", "G");
  command.flag("-y,--overwrite", options->overwrite, "Replace the picture of the difference if it exists");
  command.flag("--json", options->json, "Print the result as JSON");
}

}  // namespace morphkit::cli
