#include "cli/cmd_bench.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {

void add_bench(CommandLine& line, Session& session) {
  auto options = std::make_shared<BenchOptions>();
  Options command = add_command(line, session,
                                {"bench", "Measure how fast this machine is, stage by stage",
                                 "  morphkit bench\n"
                                 "  morphkit bench pair.json -j 1\n"
                                 "  morphkit bench --size 3840x2160 --lines 500 --json",
                                 kInspectGroup},
                                work_of(session, &Works::bench, options));
  command.path("PROJECT", options->project, "A project file, instead of random lines over painted pictures", "");
  command.integer("--lines", options->lines, "Number of random lines; 50", "N", {0, 100'000});
  declare_changes(command, options->changes, {KeyOption::kSize, KeyOption::kFilter});
  command.flag("--json", options->json, "Print the result as JSON");
}

}  // namespace morphkit::cli
