// morphkit: understands the command line.

#include "cli/program.h"

int main(int argc, char** argv) {
  return morphkit::cli::run_program(argc, argv, nullptr);
}
