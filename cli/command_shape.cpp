#include "cli/command_shape.h"

namespace morphkit::cli {

std::vector<std::string> command_names(const CommandShape& shape) {
  std::vector<std::string> names;
  for (const CommandShape& command : shape.commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> option_names(const CommandShape& shape) {
  std::vector<std::string> names;
  for (const OptionShape& option : shape.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

}  // namespace morphkit::cli
