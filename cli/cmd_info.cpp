#include "cli/cmd_info.h"

#include <memory>

#include "base/error.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/file_info.h"
#include "cli/terminal.h"

namespace morphkit::cli {

void add_info(CommandLine& line, Session& session) {
  auto options = std::make_shared<InfoOptions>();
  Options command = add_command(line, session,
                                {"info", "Tell what is in pictures and project files",
                                 "  morphkit info face.jpg pair.json\n"
                                 "  morphkit info plate.exr --pixels --json",
                                 kInspectGroup},
                                [options](Output& output) { return run_info(*options, output); });
  command.paths("FILE", options->files, "Pictures and projects (*.json)", "").required();
  command.flag("--pixels", options->pixels, "Decode pictures: minimum, maximum, mean, values that are not finite");
  command.flag("--json", options->json, "Print an array with one object per file");
}

int run_info(const InfoOptions& options, Output& output) {
  int exit_code = 0;
  Report all = Report::array();
  for (const std::filesystem::path& file : options.files) {
    try {
      const FileInfo info = file.extension() == ".json" ? project_info(file) : picture_info(file, options.pixels);
      if (!options.json) output.print(info.text);
      all.push(info.report);
    } catch (const Error& error) {
      output.flush();
      output.error(error.what());
      all.push(Report().set("file", file.string()).set("error", error.what()));
      if (exit_code == 0) exit_code = static_cast<int>(error.code());
    }
  }
  if (options.json) output.line(all.to_json());
  return exit_code;
}

}  // namespace morphkit::cli
