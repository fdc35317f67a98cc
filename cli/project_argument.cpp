#include "cli/project_argument.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "morph/media/image_format.h"
#include "morph/project/project.h"
#include "morph/project/set_value.h"
#include "morph/project/words.h"

namespace morphkit::cli {
namespace {

/// One of the KeyOptions.
struct KeyText {
  const char* names;  ///< the last one stands in messages
  const char* type;   ///< what the help calls the value
  const char* path;   ///< the address of the key
  const char* help;
  std::vector<std::string> (*words)() = nullptr;                ///< the values to choose from; null: any
  std::string (*value_of)(const std::string& typed) = nullptr;  ///< as the project has it; null: as typed
};

template <project::Worded T>
std::vector<std::string> words_of() {
  std::vector<std::string> words;
  words.reserve(std::size(project::Words<T>::kTable));
  for (const auto& [word, value] : project::Words<T>::kTable) words.emplace_back(word);
  return words;
}

std::string size_value(const std::string& typed) {
  const cv::Size size = parse_size(typed, "--size");
  return fmt::format("[{}, {}]", size.width, size.height);
}

KeyText text_of(KeyOption option) {
  switch (option) {
    case KeyOption::kSize:
      return {"--size", "WxH", "output.size", "Size of the output in pixels", nullptr, size_value};
    case KeyOption::kFit:
      return {"--fit", "FIT", "output.fit", "How pictures of another size are placed: contain, cover, stretch, none",
              words_of<project::Fit>};
    case KeyOption::kFilter:
      return {"--filter", "FILTER", "warp.filter",
              "How colours are found: area (default), mitchell, lanczos, bicubic, bilinear, nearest",
              words_of<warp::Filter>};
    case KeyOption::kField:
      return {"--field", "FIELD", "warp.field", "How the field of lines is evaluated: adaptive (default), exact",
              words_of<warp::FieldAccuracy>};
    case KeyOption::kFps:
      return {"--fps", "RATE", "output.fps", "Frames per second of a video: 25, 29.97, 30000/1001"};
    case KeyOption::kFrameCount:
      return {"-n,--frame-count", "N", "output.frames", "Number of frames from first to last"};
    case KeyOption::kSpline:
      return {"--spline", "SPLINE", "warp.spline", "Curves: monotone (default), catmull-rom, linear",
              words_of<warp::MeshSpline>};
    case KeyOption::kOrder:
      return {"--order", "ORDER", "warp.order", "Order of the passes: auto (default), rows-first, columns-first",
              words_of<warp::PassOrder>};
  }
  return {};
}

/// A change with the option that asks for it.
struct Change {
  std::string option;
  project::Setting setting;
};

std::vector<Change> listed(const ProjectChanges& changes) {
  std::vector<Change> list;
  for (const ProjectChanges::Key& key : changes.keys) {
    if (key.value.empty()) continue;
    const KeyText text = text_of(key.option);
    const std::string names = text.names;
    list.push_back(
        {names.substr(names.find(',') + 1), {text.path, text.value_of ? text.value_of(key.value) : key.value}});
  }
  for (const std::string& set : changes.sets) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos || equals == 0)
      throw ArgumentError("--set", fmt::format("'{}' is no change; write PATH=VALUE, as in warp.filter=lanczos", set));
    list.push_back({"--set", {set.substr(0, equals), set.substr(equals + 1)}});
  }
  return list;
}

/// The error of a key as one of the option that set it last.
[[noreturn]] void blame(const std::vector<Change>& changes, const Error& error) {
  const auto guilty = std::find_if(changes.rbegin(), changes.rend(),
                                   [&](const Change& change) { return change.setting.path == error.place(); });
  if (guilty == changes.rend()) throw error;
  const bool by_set = guilty->option == "--set";
  throw ArgumentError(guilty->option, by_set ? error.what() : error.message());
}

}  // namespace

void declare_changes(Options& command, ProjectChanges& changes, const std::vector<KeyOption>& keys) {
  for (const KeyOption key : keys) {
    const KeyText text = text_of(key);
    std::string& value = changes.keys.emplace_back(ProjectChanges::Key{key, {}}).value;
    if (text.words)
      command.choice(text.names, value, text.help, text.type, text.words());
    else
      command.text(text.names, value, text.help, text.type);
  }
  command.texts("--set", changes.sets, "Set any key of the project: warp.b=1.5, features/nose.warp.a=4", "PATH=VALUE");
}

void declare_project(Options& command, ProjectArgument& argument, const std::vector<KeyOption>& keys) {
  command.paths("PROJECT", argument.inputs, "A project file, or two pictures", "| A B", 2).required();
  command.path("--features", argument.features, "Features for two pictures: a project file, or its features alone",
               "F");
  declare_changes(command, argument.changes, keys);
}

void apply_changes(const ProjectChanges& changes, project::Project& project) {
  const std::vector<Change> list = listed(changes);
  std::vector<project::Setting> settings;
  settings.reserve(list.size());
  for (const Change& change : list) settings.push_back(change.setting);
  try {
    project::set_values(project, settings);
  } catch (const Error& error) {
    blame(list, error);
  }
}

bool is_project(const std::filesystem::path& file) {
  return file.extension() == ".json";
}

std::filesystem::path relative_to_project(const std::filesystem::path& project, const std::filesystem::path& picture) {
  const auto folder = [](const std::filesystem::path& file) { return std::filesystem::absolute(file).parent_path(); };
  return (std::filesystem::proximate(folder(picture), folder(project)) / picture.filename()).lexically_normal();
}

project::Project load_project(const std::filesystem::path& file, const ProjectChanges& changes) {
  project::Project project = project::load(file);
  apply_changes(changes, project);
  return project;
}

project::Project load_project(const ProjectArgument& argument) {
  const std::vector<std::filesystem::path>& inputs = argument.inputs;
  if (inputs.size() == 2) {
    project::Project project;
    project.pictures[project::kSource].image = inputs[0];
    project.pictures[project::kDestination].image = inputs[1];
    if (!argument.features.empty()) project::load_features(project, argument.features);
    apply_changes(argument.changes, project);
    return project;
  }
  if (!argument.features.empty())
    throw ArgumentError("--features", "goes with two pictures; a project has its own features");
  if (media::writable_format(inputs.front()) != nullptr)
    throw ArgumentError(inputs.front().string(),
                        "is one picture; give two pictures, or a project file that names them");
  return load_project(inputs.front(), argument.changes);
}

}  // namespace morphkit::cli
