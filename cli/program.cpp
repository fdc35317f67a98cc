#include "cli/program.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/cmd_bench.h"
#include "cli/cmd_check.h"
#include "cli/cmd_compare.h"
#include "cli/cmd_completion.h"
#include "cli/cmd_demo.h"
#include "cli/cmd_edit.h"
#include "cli/cmd_export.h"
#include "cli/cmd_help.h"
#include "cli/cmd_import.h"
#include "cli/cmd_info.h"
#include "cli/cmd_map.h"
#include "cli/cmd_morph.h"
#include "cli/cmd_schema.h"
#include "cli/cmd_warp.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

constexpr const char* kFooter =
    "Example:\n"
    "  morphkit demo                                  # something to watch, in a minute\n"
    "  morphkit edit a.jpg b.jpg                      # mark what corresponds; saves a-b.json\n"
    "  morphkit morph a-b.json -o morph.mp4           # a video from a project\n"
    "  morphkit help morph                            # options and examples of a command\n"
    "\n"
    "Exit codes: 0 done; 1 the work failed; 2 wrong usage; 3 bad input file; 4 could not read or write;\n"
    "            5 check or compare found something; 130 interrupted";

/// The program with all its commands. They hold on to `session`.
class Program {
 public:
  Program() {
    Options options = line.options();
    add_common_options(options, session.common);
    for (const auto add : {add_edit, add_morph, add_warp, add_map, add_import, add_export, add_check, add_info,
                           add_compare, add_bench, add_demo, add_schema, add_completion, add_help})
      add(line, session);
  }

  Session session;
  CommandLine line{"morphkit", "Bends pictures, and turns one picture into another.", "morphkit " MORPHKIT_VERSION,
                   kFooter};
};

void apply(const CommonOptions& common, Output& output) {
  if (common.quiet) {
    output.set_verbosity(Verbosity::kQuiet);
  } else if (common.verbose) {
    output.set_verbosity(Verbosity::kVerbose);
  }
  if (common.threads > 0) set_threads(common.threads);
}

int parse_and_run(int argc, const char* const* argv, Output& output) {
  Program program;
  int code = 0;
  try {
    const Action action = program.line.parse(argc, argv);
    apply(program.session.common, output);
    code = action(output);
  } catch (const UsageError& error) {
    output.error(error.what());
    output.note(fmt::format("Try '{} --help'.", error.command()));
    code = static_cast<int>(ErrorCode::kUsage);
  }
  output.flush();
  return code;
}

/// The one place where exceptions become messages and exit codes.
int guarded(Output& output, const std::function<int()>& work) {
  const auto fail = [&output](ErrorCode code, std::string_view message) {
    output.error(message);
    return static_cast<int>(code);
  };
  try {
    return work();
  } catch (const Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kFailed, "out of memory");
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::kFailed, error.code == cv::Error::StsNoMem ? "out of memory" : error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(ErrorCode::kIo, error.what());
  } catch (const std::exception& error) {
    return fail(ErrorCode::kFailed, error.what());
  }
}

}  // namespace

int run_program(int argc, const char* const* argv) noexcept {
  Output output(stdout, stderr, Verbosity::kNormal);
  return guarded(output, [&] { return parse_and_run(argc, argv, output); });
}

CommandShape program_shape() {
  return Program().line.shape();
}

}  // namespace morphkit::cli
