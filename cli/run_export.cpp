#include "cli/cmd_export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/terminal.h"
#include "morph/exchange/import.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"

namespace morphkit::cli {
namespace {

cv::Size picture_size(const project::Project& project, const project::Picture& side) {
  const media::ImageInfo info = media::read_info(project::resolve(project, side.image));
  return {info.width, info.height};
}

}  // namespace

int run_export(const ExportOptions& options, Output& output) {
  const project::Project project = load_project(options.project, options.changes);
  const exchange::ExportOutput files{options.files, picture_size(project, project.pictures[project::kSource]),
                                     picture_size(project, project.pictures[project::kDestination]), options.overwrite};
  const std::vector<std::string> remarks = as_asked([&] { return exchange::export_to(project, files); });
  for (const std::string& remark : remarks) output.note(remark);
  std::vector<std::string> names;
  for (const std::filesystem::path& file : options.files) names.push_back(file.string());
  output.note(fmt::format("{} written", fmt::join(names, ", ")));
  return 0;
}

}  // namespace morphkit::cli
