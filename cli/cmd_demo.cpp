#include "cli/cmd_demo.h"

#include <memory>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/terminal.h"
#include "cli/works.h"
#include "samples/samples.h"

namespace morphkit::cli {
namespace {

int list_samples(Output& output) {
  for (const auto& [name, title] : samples::titles()) output.line(fmt::format("{:<12} {}", name, title));
  return 0;
}

/// The list needs no picture library.
Action action_of(const Session& session, const std::shared_ptr<DemoOptions>& options) {
  return [options, paint = work_of(session, &Works::demo, options)](Output& output) {
    return options->list ? list_samples(output) : paint(output);
  };
}

}  // namespace

void add_demo(CommandLine& line, Session& session) {
  auto options = std::make_shared<DemoOptions>();
  Options command = add_command(line, session,
                                {"demo", "Paint a sample pair of pictures and morph it: something to watch and to edit",
                                 "  morphkit demo                      # into ./morphkit-demo\n"
                                 "  morphkit demo --list\n"
                                 "  morphkit demo --all -o /tmp/demo",
                                 kHelpGroup},
                                action_of(session, options));
  command.text("NAME", options->name, "Which sample (the first)",
               fmt::format("{{{}}}", fmt::join(samples::names(), ",")));
  command.path("-o,--output", options->folder, "Folder to write into (morphkit-demo)", "DIR");
  command.integer("-n,--frame-count", options->frame_count, "Number of frames, if not the project's own", "N",
                  {1, 100000});
  command.flag("--all", options->all, "All samples");
  command.flag("--list", options->list, "Print the names of the samples and stop");
  command.flag("-y,--overwrite", options->overwrite, "Replace pictures and projects that you have changed");
}

}  // namespace morphkit::cli
