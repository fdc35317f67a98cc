#include "cli/cmd_info.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/terminal.h"
#include "cli/works.h"
#include "morph/media/quick_size.h"

namespace morphkit::cli {
namespace {

/// The part that needs the picture libraries.
struct NeedsLibraries {};

/// Describes a project if that needs no picture library; otherwise returns nothing and prints nothing.
std::optional<int> run_quickly(const InfoOptions& options, Output& output) {
  if (options.files.size() != 1 || !is_project(options.files[0])) return std::nullopt;
  const auto size_of = [](const std::filesystem::path& picture) {
    const std::optional<cv::Size> size = media::quick_size(picture);
    if (!size) throw NeedsLibraries();
    return *size;
  };
  try {
    return tell(
        options, [&](const std::filesystem::path& file) { return project_info(file, options.changes, size_of); },
        output);
  } catch (const NeedsLibraries&) {
    return std::nullopt;
  }
}

Action action_of(const Session& session, const std::shared_ptr<InfoOptions>& options) {
  return [options, slow = work_of(session, &Works::info, options)](Output& output) {
    const std::optional<int> code = run_quickly(*options, output);
    return code ? *code : slow(output);
  };
}

}  // namespace

void add_info(CommandLine& line, Session& session) {
  auto options = std::make_shared<InfoOptions>();
  Options command = add_command(line, session,
                                {"info", "Tell what is in pictures and project files",
                                 "  morphkit info face.jpg pair.json\n"
                                 "  morphkit info plate.exr --pixels --json",
                                 kInspectGroup},
                                action_of(session, options));
  command.paths("FILE", options->files, "Pictures and projects (*.json)", "").required();
  declare_changes(command, options->changes);
  command.flag("--pixels", options->pixels, "Decode pictures: minimum, maximum, mean, values that are not finite");
  command.flag("--json", options->json, "Print an array with one object per file");
}

int tell(const InfoOptions& options, const InfoReader& info_of, Output& output) {
  if (!options.changes.sets.empty() && std::ranges::none_of(options.files, is_project))
    throw ArgumentError("--set", "goes with a project (*.json); here is none");
  int exit_code = 0;
  Report all = Report::array();
  for (const std::filesystem::path& file : options.files) {
    try {
      const FileInfo info = info_of(file);
      if (!options.json) output.print(info.text);
      all.push(info.report);
    } catch (const Error& error) {
      output.flush();
      output.error(error.what());
      all.push(Report().set("file", file.string()).set("error", error.what()));
      if (exit_code == 0) exit_code = exit_code_of(error.kind());
    }
  }
  if (options.json) output.line(all.to_json());
  return exit_code;
}

}  // namespace morphkit::cli
