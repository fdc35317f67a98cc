#include "cli/command_line.h"

#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/words.h"
#include "cli/help_format.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

/// CLI::NonNegativeNumber names the largest double, all 309 digits of it.
CLI::Validator at_least_zero() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        const bool valid = CLI::detail::lexical_cast(text, value) && value >= 0;
        return valid ? std::string() : fmt::format("'{}' is not a number of at least 0", text);
      },
      "");
}

/// The choices are the part of the type name in braces, "SHELL:{bash,zsh}". CLI::IsMember puts them there, and the
/// library offers no other way to them.
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

/// Explains a word that no option or argument of `app` takes.
std::string unexpected_text(const CLI::App& app, const std::string& word) {
  const bool is_option = word.size() > 1 && word.front() == '-';
  const bool is_command = !is_option && app.get_parent() == nullptr;
  if (!is_option && !is_command) return fmt::format("unexpected argument '{}'", word);
  const CommandShape shape = shape_of(app);
  const std::string name = is_option ? word.substr(0, word.find('=')) : word;
  const auto similar = nearest(name, is_option ? option_names(shape) : command_names(shape));
  std::string text = fmt::format("unknown {} '{}'", is_option ? "option" : "command", name);
  if (similar) return fmt::format("{}; did you mean '{}'?", text, *similar);
  if (is_command && std::filesystem::path(word).extension() == ".json")
    text += fmt::format("; to render a project: morphkit morph {} -o out.mp4", word);
  return text;
}

UsageError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* current = &app;
  while (!current->get_subcommands().empty()) current = current->get_subcommands().front();
  // An unknown word explains more than the option that is missing because of it.
  const std::vector<std::string> unknown = app.remaining(true);
  const std::string message = unknown.empty() ? error.what() : unexpected_text(*current, unknown.front());
  if (current == &app) return UsageError(message, app.get_name());
  return UsageError(fmt::format("{}: {}", current->get_name(), message), app.get_name() + " " + current->get_name());
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::group(const char* heading) {
  option_->group(heading);
  return *this;
}

Option Options::flag(const char* names, bool& value, const char* help) {
  return Option(*app_->add_flag(names, value, help));
}

Option Options::text(const char* names, std::string& value, const char* help, const std::string& type) {
  return Option(*app_->add_option(names, value, help)->type_name(type));
}

Option Options::texts(const char* names, std::vector<std::string>& value, const char* help, const char* type) {
  return Option(*app_->add_option(names, value, help)->type_name(type)->allow_extra_args(false));
}

// An empty description: the range does not belong in the help.
Option Options::integer(const char* names, int& value, const char* help, const char* type, Range range) {
  return Option(*app_->add_option(names, value, help)
                     ->type_name(type)
                     ->check(CLI::Range(range.least, range.most).description("")));
}

Option Options::integer(const char* names, std::optional<int>& value, const char* help, const char* type, Range range) {
  return Option(*app_->add_option(names, value, help)
                     ->type_name(type)
                     ->check(CLI::Range(range.least, range.most).description("")));
}

Option Options::real(const char* names, std::optional<double>& value, const char* help, const char* type) {
  return Option(*app_->add_option(names, value, help)->type_name(type));
}

Option Options::amount(const char* names, double& value, const char* help, const char* type) {
  return Option(*app_->add_option(names, value, help)->type_name(type)->check(at_least_zero()));
}

Option Options::choice(const char* names, std::string& value, const char* help, const char* type,
                       const std::vector<std::string>& words) {
  return Option(*app_->add_option(names, value, help)->type_name(type)->check(CLI::IsMember(words)));
}

Option Options::path(const char* names, std::filesystem::path& value, const char* help, const char* type) {
  return Option(*app_->add_option(names, value, help)->type_name(type));
}

Option Options::paths(const char* names, std::vector<std::filesystem::path>& value, const char* help, const char* type,
                      int most) {
  CLI::Option* option = app_->add_option(names, value, help)->type_name(type);
  if (most > 0) option->expected(1, most);
  return Option(*option);
}

CommandLine::CommandLine(const char* name, const char* description, const char* version, const char* footer)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->formatter(help_formatter());
  app_->get_help_ptr()->group(kCommonGroup);
  app_->set_version_flag("--version", version, "Print the version")->group(kCommonGroup);
  app_->require_subcommand(0, 1);
  app_->footer(footer);
}

CommandLine::~CommandLine() = default;

Options CommandLine::options() {
  return Options(*app_);
}

Options CommandLine::add_command(const CommandText& text, Action action) {
  CLI::App* command = app_->add_subcommand(text.name, text.summary);
  command->group(text.group);
  command->footer("Example:\n" + text.examples);
  command->get_help_ptr()->group(kCommonGroup);
  command->callback([this, action = std::move(action)] { action_ = action; });
  return Options(*command);
}

Action CommandLine::parse(int argc, const char* const* argv) {
  const auto printing = [](std::string text) {
    return [text = std::move(text)](Output& output) {
      output.print(text);
      return 0;
    };
  };
  action_ = nullptr;
  try {
    app_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return printing(app_->help());
  } catch (const CLI::CallForVersion& version) {
    return printing(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    throw usage_error(*app_, error);
  }
  return action_ ? action_ : printing(app_->help());
}

std::optional<std::string> CommandLine::help(const std::string& command) const {
  // App::help() would print the help of the command that was parsed.
  if (command.empty())
    return app_->get_formatter()->make_help(app_.get(), app_->get_name(), CLI::AppFormatMode::Normal);
  const auto named = app_->get_subcommands([&](const CLI::App* candidate) { return candidate->check_name(command); });
  if (named.empty()) return std::nullopt;
  return named.front()->help(app_->get_name());
}

CommandShape CommandLine::shape() const {
  return cli::shape_of(*app_);
}

}  // namespace morphkit::cli
