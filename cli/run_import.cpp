#include "cli/cmd_import.h"

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/project_argument.h"
#include "cli/terminal.h"
#include "morph/exchange/import.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"

namespace morphkit::cli {
namespace {

cv::Size picture_size(const std::filesystem::path& picture) {
  const media::ImageInfo info = media::read_info(picture);
  return {info.width, info.height};
}

/// Describes the project's content.
std::string summary(const project::Project& project) {
  std::string text;
  if (project.mesh) text = fmt::format("a mesh of {} x {} vertices", project.mesh->columns, project.mesh->rows);
  if (!project.features.empty()) {
    text += fmt::format("{}{} features", text.empty() ? "" : " and ", project.features.size());
  }
  return text;
}

/// The options with the pictures that the files name, where the user names none.
ImportOptions with_pictures(ImportOptions options) {
  if (!options.source.empty() && !options.destination.empty()) return options;
  const std::vector<std::filesystem::path> named = as_asked([&] { return exchange::pictures_in(options.files); });
  if (named.empty()) {
    throw ArgumentError(options.source.empty() ? "--source" : "--destination",
                        "is required, for these files name no pictures");
  }
  if (options.source.empty()) options.source = named[project::kSource];
  if (options.destination.empty()) options.destination = named[project::kDestination];
  return options;
}

}  // namespace

int run_import(const ImportOptions& asked, Output& output) {
  const ImportOptions options = with_pictures(asked);
  if (options.output.extension() != ".json")
    throw ArgumentError(options.output.string(), "is no name for a project; it should end in .json");
  project::Project project;
  project.pictures[project::kSource].image = relative_to_project(options.output, options.source);
  project.pictures[project::kDestination].image = relative_to_project(options.output, options.destination);
  const exchange::ImportInput input{options.files, picture_size(options.source), picture_size(options.destination)};
  const exchange::ImportReport report = as_asked([&] { return exchange::import_into(project, input); });
  project::save(project, options.output, options.overwrite);
  for (const std::string& remark : report.remarks) output.note(remark);
  output.note(fmt::format("{}: {} from {}", options.output.string(), summary(project), report.format));
  return 0;
}

}  // namespace morphkit::cli
