#pragma once
// morphkit completion SHELL: a completion script on standard output.

#include <string>

#include "cli/command_shape.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct CompletionOptions {
  std::string shell;  ///< "bash" | "zsh" | "fish"
};

void add_completion(CommandLine& line, Session& session);

/// @throws ArgumentError for an unknown shell.
int run_completion(const CompletionOptions& options, const CommandShape& program, Output& output);

}  // namespace morphkit::cli
