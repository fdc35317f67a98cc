#include "cli/cmd_edit.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/cmd_morph.h"
#include "cli/command_line.h"
#include "cli/edit/document/project_lock.h"
#include "cli/edit/document/storage.h"
#include "cli/edit/hand/editor.h"
#include "cli/edit/view/layout.h"
#include "cli/edit/window.h"
#include "cli/exit_code.h"
#include "cli/terminal.h"
#include "morph/job/pictures.h"

namespace morphkit::cli {
namespace {

namespace fs = std::filesystem;

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

/// @throws Error unless that side of a project shows this picture.
void require_picture(const project::Project& project, const project::Picture& side, const fs::path& picture) {
  std::error_code error;
  if (!fs::exists(picture, error)) throw Error(ErrorKind::kIo, picture.string(), "does not exist");
  if (!same_file(project::resolve(project, side.image), picture))
    throw ArgumentError(
        project.file.string(),
        fmt::format("is a project of other pictures ({}); name another file with -o", side.image.string()));
}

/// The window reads its pictures once, and undoing does not bring others. @throws Error if --set names others.
project::Project with_own_pictures(project::Project project) {
  if (project.original && project::parse(*project.original, project.file).pictures != project.pictures)
    throw ArgumentError("--set", "the pictures of a project stay while it is edited; change them in its file");
  return project;
}

cv::Size window_size(const std::string& text) {
  const cv::Size size = parse_size(text, "--window");
  const cv::Size least = edit::kMinCanvas;
  if (size.width < least.width || size.height < least.height || size.width > 7680 || size.height > 4320)
    throw ArgumentError("--window",
                        fmt::format("{} is out of range; from {}x{} to 7680x4320", text, least.width, least.height));
  return size;
}

}  // namespace

project::Project project_to_edit(const EditOptions& options) {
  project::Project project = load_project(options.project);
  const std::vector<fs::path>& inputs = options.project.inputs;
  if (inputs.size() == 1) {
    if (!options.output.empty())
      throw ArgumentError("--output", "goes with two pictures; a project is saved to its own file");
    return with_own_pictures(std::move(project));
  }
  fs::path file = options.output;
  if (file.empty()) file = inputs[0].stem().string() + "-" + inputs[1].stem().string() + ".json";
  std::error_code error;
  if (fs::exists(file, error)) {
    if (!options.project.features.empty())
      throw ArgumentError("--features",
                          fmt::format("{} is there already and has its own; name another file with -o", file.string()));
    project::Project there = load_project(file, options.project.changes);
    require_picture(there, there.pictures[project::kSource], inputs[0]);
    require_picture(there, there.pictures[project::kDestination], inputs[1]);
    return with_own_pictures(std::move(there));
  }
  for (project::Picture& picture : project.pictures)
    if (picture.image.is_relative()) picture.image = relative_to_project(file, picture.image);
  project.file = file;
  return project;
}

int run_edit(const EditOptions& options, Output& output) {
  const cv::Size window = window_size(options.window);
  project::Project project = project_to_edit(options);
  edit::require_savable(project);
  edit::require_display();
  const job::Pictures pictures = job::load_pictures(project);
  warn_of_pixels(project, pictures, output);
  warn_of_unused_settings(project, output);
  output.note(fmt::format("editing {}; h in the window shows every key", project.file.string()));
  edit::ProjectLock lock = edit::ProjectLock::claim(project.file);
  for (const std::string& other : lock.others())
    output.warning(fmt::format("{} is also being edited by {}", project.file.string(), other));
  edit::Editor editor(std::move(project), job::footage_of(pictures), window, std::move(lock));
  edit::run_window(editor);
  return 0;
}

}  // namespace morphkit::cli
