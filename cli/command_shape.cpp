#include "cli/command_shape.h"

#include <CLI/CLI.hpp>

namespace morphkit::cli {
namespace {

/// Choices are the part of the type name in braces, "SHELL:{bash,zsh}": there CLI::IsMember puts them, and the library
/// offers no other way to them.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.rfind('{');
  const std::size_t end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

OptionShape shape_of(const CLI::Option& option) {
  OptionShape shape;
  for (const std::string& name : option.get_snames()) shape.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) shape.names.push_back("--" + name);
  const std::string& description = option.get_description();
  shape.description = description.substr(0, description.find('\n'));
  shape.takes_value = option.get_items_expected_max() > 0;
  const std::string type = option.get_type_name();
  shape.takes_file = type == "FILE" || type == "DIR" || type.starts_with("OUT") || type == "F";
  shape.choices = choices_of(option);
  return shape;
}

}  // namespace

CommandShape shape_of(const CLI::App& app) {
  CommandShape shape{app.get_name(), app.get_description(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      for (const std::string& choice : choices_of(*option)) shape.positional_choices.push_back(choice);
    } else {
      shape.options.push_back(shape_of(*option));
    }
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    shape.commands.push_back(shape_of(*command));
  }
  return shape;
}

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
