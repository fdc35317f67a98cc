#include "cli/cmd_demo.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <unistd.h>

#include <fmt/format.h>

#include "base/words.h"
#include "cli/cmd_morph.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/terminal.h"
#include "samples/samples.h"
#include "samples/write.h"

namespace morphkit::cli {
namespace {

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::vector<std::string> chosen_names(const DemoOptions& options) {
  std::vector<std::string> names = samples::names();
  if (options.all) return names;
  if (options.name.empty()) return {names.front()};
  if (std::find(names.begin(), names.end(), options.name) != names.end()) return {options.name};
  const auto similar = nearest(options.name, names);
  throw ArgumentError(
      "demo", fmt::format("there is no sample '{}'; {}", options.name,
                          similar ? fmt::format("did you mean '{}'?", *similar) : "morphkit demo --list names them"));
}

void print_files(const samples::Sample& sample, const std::filesystem::path& project_file,
                 const std::filesystem::path& rendered, Output& output) {
  output.line(fmt::format("{}: {}", sample.name, sample.title));
  for (const samples::PaintedPicture& picture : sample.pictures) {
    output.line(fmt::format("  {:<40} a picture", (project_file.parent_path() / picture.name).string()));
  }
  output.line(fmt::format("  {:<40} the project: what corresponds to what", project_file.string()));
  output.line(fmt::format("  {:<40} the morph: watch this", rendered.string()));
}

void print_next_steps(const std::filesystem::path& project_file, Output& output) {
  const std::string file = project_file.string();
  output.line("\nTry next:");
  output.line(fmt::format("  morphkit edit {}", file));
  output.line(fmt::format("  morphkit morph {} -t 0.5 -o middle.png", file));
  output.line("  and with two pictures of your own: morphkit edit a.jpg b.jpg");
}

std::filesystem::path write_sample(const samples::Sample& sample, const DemoOptions& options) {
  try {
    return samples::write(sample, options.folder, options.overwrite);
  } catch (const samples::ChangedFile& error) {
    throw Error(error.kind(), error.place(), error.message() + "; -y replaces it, -o writes into another folder");
  }
}

std::filesystem::path demo_one(const std::string& name, const DemoOptions& options, bool video, Output& output) {
  const samples::Sample sample = samples::paint(name);
  std::filesystem::path project_file = write_sample(sample, options);
  MorphOptions morph;
  morph.project.inputs = {project_file};
  morph.output = options.folder / (name + (video ? ".mp4" : ".####.png"));
  if (options.frame_count > 0) morph.project.changes.sets = {fmt::format("output.frames={}", options.frame_count)};
  morph.overwrite = true;
  run_morph(morph, output);
  print_files(sample, project_file, morph.output, output);
  return project_file;
}

}  // namespace

int run_demo(const DemoOptions& options, Output& output) {
  const std::vector<std::string> names = chosen_names(options);
  const bool video = on_path("ffmpeg");
  if (!video) output.warning("the program ffmpeg is not installed: writing numbered pictures instead of a video");
  std::filesystem::path first;
  for (const std::string& name : names) {
    const std::filesystem::path project_file = demo_one(name, options, video, output);
    if (first.empty()) first = project_file;
  }
  print_next_steps(first, output);
  return 0;
}

}  // namespace morphkit::cli
