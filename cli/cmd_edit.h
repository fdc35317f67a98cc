#pragma once
// morphkit edit: mark features on two pictures in a window and watch the morph change.

#include <filesystem>
#include <string>

#include "cli/project_argument.h"
#include "morph/project/project.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct EditOptions {
  ProjectArgument project;
  std::filesystem::path output;     ///< the project file for two pictures; empty: see project_to_edit
  std::string window = "1600x900";  ///< size of the canvas, px
};

void add_edit(CommandLine& line, Session& session);

/// @return the exit code.
int run_edit(const EditOptions& options, Output& output);

/// The project that is to be edited, with the file that it is saved to. For two pictures A and B that is `output`, or
/// "A-B.json" of their names without extensions in the current directory; an existing file that names the same pictures
/// is continued.
/// @throws ArgumentError if that file is of other pictures, and as project::load.
project::Project project_to_edit(const EditOptions& options);

}  // namespace morphkit::cli
