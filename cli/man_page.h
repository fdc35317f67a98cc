#pragma once
// Manual pages, made from the help that the program prints.

#include <string>
#include <vector>

namespace morphkit::cli {

/// The texts of a manual page.
struct ManPage {
  std::string command;  ///< "morphkit" or "morphkit morph"
  std::string version;
  std::string help;  ///< as `morphkit help` prints it: description, usage, groups of two columns, examples
  std::vector<std::string> see_also;  ///< other commands, in the form of `command`
};

/// The page in section 1, in the `man` macros of roff.
std::string to_roff(const ManPage& page);

}  // namespace morphkit::cli
