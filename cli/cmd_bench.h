#pragma once
// morphkit bench: how fast this machine is, stage by stage.

#include <filesystem>
#include <optional>

#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct BenchOptions {
  std::filesystem::path project;  ///< empty: lines at random over painted pictures
  ProjectChanges changes;         ///< of either
  std::optional<int> lines;       ///< of painted pictures; nothing: 50
  bool json = false;
};

void add_bench(CommandLine& line, Session& session);

/// @return the exit code.
int run_bench(const BenchOptions& options, Output& output);

}  // namespace morphkit::cli
