#include "cli/help_format.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

namespace morphkit::cli {
namespace {

constexpr std::size_t kNameColumns = 28;
constexpr std::size_t kTextColumns = 80 - kNameColumns;

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(kNameColumns);
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
  }

  std::string make_description(const CLI::App* app) const override {
    return wrapped(CLI::Formatter::make_description(app), kNameColumns + kTextColumns);
  }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    return make_description(app) + make_usage(app, name) + make_positionals(app) + option_groups(app) +
           make_subcommands(app, mode) + "\n" + make_footer(app);
  }

  /// The name of the value alone: the description lists the choices in words.
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return "";
    const std::string type = option->get_type_name();
    const std::string name = type.substr(0, type.find_first_of(":{"));
    std::string text = name.empty() ? "" : " " + name;
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    if (option->get_required() && option->nonpositional()) text += " (required)";
    return text;
  }

  std::string make_option_usage(const CLI::Option* option) const override {
    std::string text = make_option_name(option, true) + make_option_opts(option);
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text.erase(text.size() - 4, 1);
    return option->get_required() ? text : "[" + text + "]";
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description(), kTextColumns);
  }

  std::string make_subcommand(const CLI::App* command) const override {
    std::stringstream out;
    CLI::detail::format_help(out, command->get_name(), wrapped(command->get_description(), kTextColumns),
                             get_column_width());
    return out.str();
  }

 private:
  std::string option_groups(const CLI::App* app) const {
    std::vector<std::string> groups = app->get_groups();
    std::stable_partition(groups.begin(), groups.end(), [](const std::string& group) { return group != kCommonGroup; });
    std::string text;
    for (const std::string& group : groups) {
      const auto options = app->get_options(
          [&group](const CLI::Option* option) { return option->get_group() == group && option->nonpositional(); });
      if (!options.empty()) text += make_group(group, false, options);
    }
    return text;
  }
};

}  // namespace

std::string wrapped(const std::string& text, std::size_t columns) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::size_t used = 0;
    if (!result.empty()) result += '\n';
    for (std::string word; words >> word; used += word.size()) {
      const bool breaks = used > 0 && used + 1 + word.size() > columns;
      if (breaks) used = 0;
      if (used > 0) ++used;
      if (!result.empty() && result.back() != '\n') result += breaks ? '\n' : ' ';
      result += word;
    }
  }
  return text.ends_with('\n') ? result + '\n' : result;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

}  // namespace morphkit::cli
