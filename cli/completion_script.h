#pragma once
// Completion scripts for shells, made from the shape of the program.

#include <string>

#include "cli/command_shape.h"

namespace morphkit::cli {

std::string bash_completion(const CommandShape& program);
std::string zsh_completion(const CommandShape& program);
std::string fish_completion(const CommandShape& program);

}  // namespace morphkit::cli
