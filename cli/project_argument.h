#pragma once
// A project as an argument of a command: a project file or two pictures, and the options that change keys of it.

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace morphkit::project {
struct Project;
}

namespace morphkit::cli {

class Options;

/// The options that are short for --set with one key.
enum class KeyOption { kSize, kFit, kFilter, kField, kFps, kFrameCount, kSpline, kOrder };

/// What the command line changes in a project: `keys` first, then `sets` in their order, so that --set has the last
/// word. Not to be copied between declaring and parsing: the parser refers to the values.
struct ProjectChanges {
  struct Key {
    KeyOption option;
    std::string value;  ///< as typed; empty: not given
  };
  std::deque<Key> keys;
  std::vector<std::string> sets;  ///< "warp.filter=lanczos"
};

struct ProjectArgument {
  std::vector<std::filesystem::path> inputs;  ///< a project, or two pictures
  std::filesystem::path features;             ///< for two pictures; empty: none
  ProjectChanges changes;
};

/// Declares --set and these options.
void declare_changes(Options& command, ProjectChanges& changes, const std::vector<KeyOption>& keys = {});

/// Declares PROJECT | A B, --features, --set and these options.
void declare_project(Options& command, ProjectArgument& argument, const std::vector<KeyOption>& keys = {});

/// Changes `project`. @throws ArgumentError, which names the option, if there is no such key or it does not take the
/// value; `project` is then unchanged.
void apply_changes(const ProjectChanges& changes, project::Project& project);

/// Whether an argument that may be a picture or a mesh is a project: *.json.
bool is_project(const std::filesystem::path& file);

/// `picture` as `project`, a file, names it: both are given from the current directory, and the path begins at the
/// folder of the project. Links among the folders are followed, as opening the path does; a link to the picture
/// itself keeps its name.
std::filesystem::path relative_to_project(const std::filesystem::path& project, const std::filesystem::path& picture);

/// The project that a command's argument names, changed.
/// @throws ArgumentError if it is neither a project nor two pictures; as project::load and apply_changes.
project::Project load_project(const ProjectArgument& argument);
project::Project load_project(const std::filesystem::path& file, const ProjectChanges& changes);

}  // namespace morphkit::cli
