#pragma once
// morphkit check PROJECT: what will tear, fold or be lost, before it is rendered.

#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct CheckOptions {
  ProjectArgument project;
  bool json = false;
};

void add_check(CommandLine& line, Session& session);

/// @return 0 if there is nothing to warn of, else kExitDifference.
int run_check(const CheckOptions& options, Output& output);

}  // namespace morphkit::cli
