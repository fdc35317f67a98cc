#pragma once
// morphkit check PROJECT: what will tear, fold or be lost, before anybody renders it.

#include <filesystem>
#include <vector>

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct CheckOptions {
  std::vector<std::filesystem::path> inputs;  ///< a project, or two pictures
  std::filesystem::path features;             ///< for two pictures; empty: none
  bool json = false;
};

void add_check(CommandLine& line, Session& session);

/// @return 0 if there is nothing to warn of, else kExitDifference.
int run_check(const CheckOptions& options, Output& output);

}  // namespace morphkit::cli
