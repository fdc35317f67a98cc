#include "cli/cmd_import.h"

#include <filesystem>
#include <utility>
#include <vector>

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

/// The source's picture and the destination's: as the user names them, else as the files do.
std::pair<std::filesystem::path, std::filesystem::path> pictures_of(const ImportOptions& options) {
  std::filesystem::path source = options.source, destination = options.destination;
  if (!source.empty() && !destination.empty()) return {source, destination};
  const std::vector<std::filesystem::path> named = as_asked([&] { return exchange::pictures_in(options.files); });
  if (named.empty())
    throw ArgumentError(source.empty() ? "--source" : "--destination", "is required, for these files name no pictures");
  if (source.empty()) source = named[project::kSource];
  if (destination.empty()) destination = named[project::kDestination];
  return {source, destination};
}

}  // namespace

int run_import(const ImportOptions& options, Output& output) {
  const auto [source, destination] = pictures_of(options);
  if (options.output.extension() != ".json")
    throw ArgumentError(options.output.string(), "is no name for a project; it should end in .json");
  project::Project project;
  project.pictures[project::kSource].image = relative_to_project(options.output, source);
  project.pictures[project::kDestination].image = relative_to_project(options.output, destination);
  const exchange::ImportInput input{options.files, picture_size(source), picture_size(destination)};
  const exchange::ImportReport report = as_asked([&] { return exchange::import_into(project, input); });
  project::save(project, options.output, options.overwrite);
  for (const std::string& remark : report.remarks) output.note(remark);
  output.note(fmt::format("{}: {} from {}", options.output.string(), summary(project), report.format));
  return 0;
}

}  // namespace morphkit::cli
