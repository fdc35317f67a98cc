#include "cli/command.h"

#include <utility>

#include "cli/help_format.h"

namespace morphkit::cli {

void add_common_options(Options& options, CommonOptions& common) {
  options.flag("-q,--quiet", common.quiet, "Print results, warnings and errors only").group(kCommonGroup);
  options.flag("-v,--verbose", common.verbose, "Tell more about what is done; --quiet wins").group(kCommonGroup);
  options
      .integer("-j,--threads", common.threads, "Threads to use; 0: all. The result never depends on it", "N", {0, 1024})
      .group(kCommonGroup);
}

Options add_command(CommandLine& line, Session& session, const CommandText& text, Action action) {
  Options options = line.add_command(text, std::move(action));
  add_common_options(options, session.common);
  return options;
}

}  // namespace morphkit::cli
