#include "cli/program.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <opencv2/core.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "base/words.h"
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
#include "cli/help_format.h"
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

std::unique_ptr<CLI::App> make_app(Session& session) {
  auto app = std::make_unique<CLI::App>("Bends pictures, and turns one picture into another.", "morphkit");
  app->formatter(help_formatter());
  app->set_version_flag("--version", "morphkit " MORPHKIT_VERSION, "Print the version")->group(kCommonGroup);
  add_common_options(*app, session.common);
  app->require_subcommand(0, 1);
  app->footer(kFooter);
  add_edit(*app, session);
  add_morph(*app, session);
  add_warp(*app, session);
  add_map(*app, session);
  add_import(*app, session);
  add_export(*app, session);
  add_check(*app, session);
  add_info(*app, session);
  add_compare(*app, session);
  add_bench(*app, session);
  add_demo(*app, session);
  add_schema(*app, session);
  add_completion(*app, session);
  add_help(*app, session);
  return app;
}

/// What is wrong with the word that no option or argument of `app` could take.
std::string unexpected_text(const CLI::App& app, const std::string& word) {
  const bool is_option = word.size() > 1 && word.front() == '-';
  const bool is_command = !is_option && app.get_parent() == nullptr;
  if (!is_option && !is_command) return fmt::format("unexpected argument '{}'", word);
  const CommandShape shape = shape_of(app);
  const std::string name = is_option ? word.substr(0, word.find('=')) : word;
  const auto similar = nearest(name, is_option ? option_names(shape) : command_names(shape));
  std::string text = fmt::format("unknown {} '{}'", is_option ? "option" : "command", name);
  if (similar) return fmt::format("{}; did you mean '{}'?", text, *similar);
  const std::filesystem::path path(word);
  if (is_command && path.extension() == ".json") {
    text += fmt::format("; to render a project: morphkit morph {} -o out.mp4", word);
  }
  return text;
}

int report_usage(const CLI::App& app, const CLI::ParseError& error, Output& output) {
  const CLI::App* current = &app;
  while (!current->get_subcommands().empty()) current = current->get_subcommands().front();
  const bool in_command = current != &app;
  const std::string command = in_command ? "morphkit " + current->get_name() : "morphkit";
  // An unknown word explains more than the option that is missing because of it.
  const std::vector<std::string> unknown = app.remaining(true);
  const std::string message = unknown.empty() ? error.what() : unexpected_text(*current, unknown.front());
  output.error(in_command ? fmt::format("{}: {}", current->get_name(), message) : message);
  output.note(fmt::format("Try '{} --help'.", command));
  return static_cast<int>(ErrorCode::kUsage);
}

int run_session(const CLI::App& app, const Session& session, Output& output) {
  if (session.common.quiet) {
    output.set_verbosity(Verbosity::kQuiet);
  } else if (session.common.verbose) {
    output.set_verbosity(Verbosity::kVerbose);
  }
  if (!session.action) {
    output.print(app.help());
    return 0;
  }
  if (session.common.threads > 0) set_threads(session.common.threads);
  return session.action(output);
}

int parse_and_run(int argc, const char* const* argv, Output& output) {
  Session session;
  const std::unique_ptr<CLI::App> app = make_app(session);
  int code = 0;
  try {
    app->parse(argc, argv);
    code = run_session(*app, session, output);
  } catch (const CLI::CallForHelp&) {
    output.print(app->help());
  } catch (const CLI::CallForVersion& version) {
    output.line(version.what());
  } catch (const CLI::ParseError& error) {
    code = report_usage(*app, error, output);
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
  Session session;
  return shape_of(*make_app(session));
}

}  // namespace morphkit::cli
