#include "cli/program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include <fcntl.h>

#include <fmt/format.h>

#include "base/atomic_file.h"
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
#include "cli/exit_code.h"
#include "cli/terminal.h"
#include "morph/render/fold_error.h"

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

/// The program with all its commands, which refer to its members.
class Program {
 public:
  explicit Program(const Works* works, const char* const* argv = nullptr) {
    session.works = works;
    session.argv = argv;
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
}

/// The first argument that is read as an option and is the name of a file; empty if there is none.
std::string_view file_like_an_option(std::span<const char* const> arguments) {
  for (const std::string_view argument : arguments) {
    std::error_code error;
    if (argument == "--") return {};
    if (argument.starts_with('-') && std::filesystem::exists(argument, error)) return argument;
  }
  return {};
}

int parse_and_run(int argc, const char* const* argv, const Works* works, Output& output) {
  Program program(works, argv);
  int code = 0;
  try {
    const Action action = program.line.parse(argc, argv);
    apply(program.session.common, output);
    code = action(output);
  } catch (const UsageError& error) {
    output.error(error.what());
    if (const std::string_view file = file_like_an_option({argv, static_cast<std::size_t>(argc)}); !file.empty())
      output.note(fmt::format("'{0}' is a file: write ./{0}, or put -- before the files.", file));
    output.note(fmt::format("Try '{} --help'.", error.command()));
    code = kExitUsage;
  }
  output.flush();
  return code;
}

/// A standard stream that the caller has closed would hand its number to the first file that is opened, and messages
/// would end up in a picture. A descriptor that cannot be written takes its place.
void hold_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) == -1) open("/dev/null", O_RDONLY | O_NOCTTY);
  }
}

/// The one place where exceptions become messages, with the options that help, and exit codes.
int guarded(Output& output, const std::function<int()>& work) {
  const auto fail = [&output](int code, std::string_view message) {
    output.error(message);
    return code;
  };
  try {
    return work();
  } catch (const FileExists& error) {
    return fail(kExitIo, fmt::format("{}; use --overwrite to replace it", error.what()));
  } catch (const render::FoldError& error) {
    return fail(kExitBadInput, fmt::format("{}, or render what can be rendered with --allow-folds", error.what()));
  } catch (const ArgumentError& error) {
    return fail(kExitUsage, error.what());
  } catch (const Error& error) {
    return fail(exit_code_of(error.kind()), error.what());
  } catch (const std::bad_alloc&) {
    return fail(kExitFailed, "out of memory");
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(kExitIo, error.what());
  } catch (const std::exception& error) {
    return fail(kExitFailed, error.what());
  }
}

}  // namespace

int run_program(int argc, const char* const* argv, const Works* works) noexcept {
  hold_standard_streams();
  // A reader that has gone away is a write error like any other, with its message and exit code.
  std::signal(SIGPIPE, SIG_IGN);
  Output output(stdout, stderr, Verbosity::kNormal);
  return guarded(output, [&] { return parse_and_run(argc, argv, works, output); });
}

CommandShape program_shape() {
  return Program(nullptr).line.shape();
}

}  // namespace morphkit::cli
