#pragma once
// morphkit warp: bend one image.

#include <filesystem>
#include <string>

#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

/// One image in, one out. The option that gives the shape (so far --mesh) chooses the method.
struct WarpOptions {
  std::filesystem::path image;
  std::filesystem::path mesh;  ///< to bend onto: a .mesh file, or a project's destination mesh
  std::filesystem::path from;  ///< that lies on the image: likewise (source mesh); empty: the project's, or even
  std::filesystem::path output;
  std::filesystem::path intermediate;  ///< the image between the passes; empty: not wanted
  ProjectChanges changes;  ///< of the project that `mesh` names; its size, spline and order count as changed
  std::string depth = "auto";
  int quality = -1;  ///< JPEG and WebP 1..100
  bool allow_folds = false;
  bool overwrite = false;
};

void add_warp(CommandLine& line, Session& session);

/// @return the exit code.
int run_warp(const WarpOptions& options, Output& output);

}  // namespace morphkit::cli
