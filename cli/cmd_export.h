#pragma once
// morphkit export: a project's correspondences for other tools.

#include <filesystem>
#include <vector>

#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct ExportOptions {
  std::filesystem::path project;
  ProjectChanges changes;
  std::vector<std::filesystem::path> files;  ///< to write, the source's first
  bool overwrite = false;
};

void add_export(CommandLine& line, Session& session);

/// @return the exit code. @throws Error as exchange::export_to.
int run_export(const ExportOptions& options, Output& output);

}  // namespace morphkit::cli
