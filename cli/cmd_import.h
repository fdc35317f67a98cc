#pragma once
// morphkit import: other tools' correspondences become a project.

#include <filesystem>
#include <vector>

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct ImportOptions {
  std::vector<std::filesystem::path> files;   ///< of the other tool, the source's first
  std::filesystem::path source, destination;  ///< the pictures; empty: as the files name them
  std::filesystem::path output;               ///< the project
  bool overwrite = false;
};

void add_import(CommandLine& line, Session& session);

/// The project names its pictures relative to itself.
/// @return the exit code. @throws Error as exchange::import_into; kIo if the project exists and `overwrite` is off.
int run_import(const ImportOptions& options, Output& output);

}  // namespace morphkit::cli
