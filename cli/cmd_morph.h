#pragma once
// morphkit morph: render a morph into frames, a video, an animation or one picture.

#include <filesystem>
#include <optional>
#include <string>

#include "cli/project_argument.h"
#include "morph/job/pictures.h"
#include "morph/project/project.h"

namespace morphkit::render {
class Renderer;
}

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct MorphOptions {
  ProjectArgument project;
  std::filesystem::path output;
  std::string frames;       ///< "1-240x2"; empty: all
  std::optional<double> t;  ///< one picture at this moment instead of frames
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

/// Prints the warnings of media::warnings_of.
void warn_of_pixels(const std::filesystem::path& file, const media::Picture& picture, Output& output);
void warn_of_pixels(const project::Project& project, const job::Pictures& pictures, Output& output);

/// Warns of every setting that the project's method does not use.
void warn_of_unused_settings(const project::Project& project, Output& output);

/// "canvas 640x480, 12 lines": what is about to be rendered.
std::string canvas_note(const render::Renderer& renderer);

/// A note about a mesh that is not used; empty if there is none.
std::string unused_mesh_note(const project::Project& project);

}  // namespace morphkit::cli
