#pragma once
// morphkit morph: render a morph into frames, a video, an animation or one picture.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "morph/media/image_file.h"
#include "morph/project/project.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct MorphOptions {
  std::vector<std::filesystem::path> inputs;  ///< a project, or two pictures
  std::filesystem::path features;             ///< for two pictures; empty: none
  std::filesystem::path output;
  std::string frames;       ///< "1-240x2"; empty: all
  std::optional<double> t;  ///< one picture at this moment instead of frames
  int frame_count = 0;      ///< 0: as the project says
  std::string size;         ///< "1280x720"; empty: as the project says
  std::string fps;          ///< "25", "29.97", "30000/1001"; empty: as the project says
  std::string filter;       ///< of filter_names(); empty: as the project says
  std::string field;        ///< of field_names(); empty: as the project says
  std::string fit;          ///< "contain" | "cover" | "stretch" | "none"; empty: as the project says
  std::string depth = "auto";
  int compression = -1;  ///< PNG, TIFF, EXR, APNG 0..9; -1: a good default
  std::string preset;    ///< of .mp4 and .webm; empty: a good default
  int quality = -1;      ///< JPEG and WebP 1..100; CRF of videos; -1: a good default
  bool allow_folds = false;
  bool overwrite = false;
  bool resume = false;
  bool json = false;
};

void add_morph(CommandLine& line, Session& session);

/// @return the exit code.
int run_morph(const MorphOptions& options, Output& output);

/// The project that a command's arguments name: a project file, or two pictures with or without features.
/// @throws Error kUsage if they are neither; as project::load.
project::Project project_from(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& features);

/// Tells of pixels that are NaN or infinite, if there are any.
void warn_of_nonfinite(const std::filesystem::path& file, const media::Picture& picture, Output& output);

/// Warns of every setting that the project's method does not use.
void warn_of_unused_settings(const project::Project& project, Output& output);

/// What to say of a project whose mesh is not used; empty if there is nothing to say.
std::string unused_mesh_note(const project::Project& project);

}  // namespace morphkit::cli
