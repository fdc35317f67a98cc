#include "cli/cmd_info.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/command.h"
#include "cli/file_info.h"
#include "cli/terminal.h"

namespace morphkit::cli {

void add_info(CLI::App& app, Session& session) {
  CLI::App* command = add_command(app, session,
                                  {"info", "Tell what is in pictures and project files",
                                   "  morphkit info face.jpg pair.json\n"
                                   "  morphkit info plate.exr --pixels --json",
                                   kInspectGroup});
  auto options = std::make_shared<InfoOptions>();
  command->add_option("FILE", options->files, "Pictures and projects (*.json)")->type_name("")->required();
  command->add_flag("--pixels", options->pixels, "Decode pictures: minimum, maximum, mean, values that are not finite");
  command->add_flag("--json", options->json, "Print an array with one object per file");
  command->callback(
      [&session, options] { session.action = [options](Output& output) { return run_info(*options, output); }; });
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
