#pragma once
// morphkit map: the map itself, as an STMap for any compositor.

#include <filesystem>
#include <optional>
#include <string>

#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct MapOptions {
  ProjectArgument project;
  std::optional<double> t;             ///< one moment
  std::string frames;                  ///< or frames: "1-48"
  std::string side = "source";         ///< "source" | "destination"
  std::string origin = "bottom-left";  ///< "bottom-left" | "top-left"
  std::filesystem::path output;
  bool allow_folds = false;
  bool overwrite = false;
};

void add_map(CommandLine& line, Session& session);

/// @return the exit code.
int run_map(const MapOptions& options, Output& output);

}  // namespace morphkit::cli
