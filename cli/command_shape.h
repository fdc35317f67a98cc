#pragma once
// The commands and options of the program as plain data: what completion scripts are made from and the documentation
// is checked against.

#include <string>
#include <vector>

namespace morphkit::cli {

struct OptionShape {
  std::vector<std::string> names;  ///< "-o", "--output"
  std::string description;         ///< its first line
  bool takes_value = false;
  bool takes_file = false;           ///< its value is named FILE, DIR, OUT or F in the help
  std::vector<std::string> choices;  ///< the only values it takes, if it is such an option
};

struct CommandShape {
  std::string name;
  std::string description;
  std::vector<OptionShape> options;
  std::vector<std::string> positional_choices;  ///< what its arguments can be; empty: files
  std::vector<CommandShape> commands;
};

/// Names of the commands directly below `shape`.
std::vector<std::string> command_names(const CommandShape& shape);

/// All spellings of all options of `shape`.
std::vector<std::string> option_names(const CommandShape& shape);

}  // namespace morphkit::cli
