#pragma once
// morphkit bench: how fast this machine is, stage by stage.

#include <filesystem>
#include <optional>
#include <string>

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct BenchOptions {
  std::filesystem::path project;  ///< empty: lines at random over painted pictures
  std::string size;               ///< "1280x720"; empty: as the project says, or 1920x1080
  std::optional<int> lines;       ///< of painted pictures; nothing: 50
  std::string filter;             ///< empty: as the project says
  bool json = false;
};

void add_bench(CommandLine& line, Session& session);

/// @return the exit code.
int run_bench(const BenchOptions& options, Output& output);

}  // namespace morphkit::cli
