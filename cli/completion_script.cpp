#include "cli/completion_script.h"

#include <fmt/format.h>

namespace morphkit::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const char* separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

/// `text` for single quotes in sh.
std::string quoted(const std::string& text) {
  return fmt::format("'{}'", replaced(text, "'", "'\\''"));
}

/// Branches of bash's case for the value of an option: its choices, a file name, or no proposals.
std::string bash_value_branches(const CommandShape& command, const std::string& key) {
  std::string text;
  for (const OptionShape& option : command.options) {
    if (!option.takes_value) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(fmt::format("'{} {}'", key, name));
    std::string action = option.takes_file ? "_morphkit_files" : ":";
    if (!option.choices.empty()) action = fmt::format("_morphkit_words '{}'", joined(option.choices, " "));
    text += fmt::format("    {}) {}; return ;;\n", joined(patterns, "|"), action);
  }
  return text;
}

std::string bash_word_branch(const CommandShape& command, const std::string& key) {
  const std::string options = fmt::format("_morphkit_words '{}'", joined(option_names(command), " "));
  const std::string words =
      joined(!command.commands.empty() ? command_names(command) : command.positional_choices, " ");
  const std::string other = words.empty() ? "_morphkit_files" : fmt::format("_morphkit_words '{}'", words);
  return fmt::format("    '{}') if [[ $word == -* ]]; then {}; else {}; fi ;;\n", key, options, other);
}

std::string zsh_text(const std::string& text) {
  return replaced(replaced(replaced(text, "[", "\\["), "]", "\\]"), ":", "\\:");
}

std::string zsh_option(const OptionShape& option, const std::string& name) {
  std::string action = option.takes_file ? "_files" : " ";
  if (!option.choices.empty()) action = fmt::format("({})", joined(option.choices, " "));
  const std::string value = option.takes_value ? ":value:" + action : "";
  return quoted(fmt::format("{}[{}]{}", name, zsh_text(option.description), value));
}

std::string zsh_arguments(const CommandShape& command, const std::string& indent) {
  std::string text;
  for (const OptionShape& option : command.options) {
    for (const std::string& name : option.names) text += fmt::format(" \\\n{}{}", indent, zsh_option(option, name));
  }
  return text;
}

std::string fish_option(const OptionShape& option, const std::string& condition) {
  std::string text = "complete -c morphkit -n " + quoted(condition);
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.choices.empty()) {
    text += fmt::format(" -x -a {}", quoted(joined(option.choices, " ")));
  } else if (option.takes_value) {
    text += option.takes_file ? " -r" : " -x";
  }
  return text + " -d " + quoted(option.description) + "\n";
}

}  // namespace

std::string bash_completion(const CommandShape& program) {
  std::string values = bash_value_branches(program, "");
  std::string words = bash_word_branch(program, "");
  for (const CommandShape& command : program.commands) {
    values += bash_value_branches(command, command.name);
    words += bash_word_branch(command, command.name);
  }
  return fmt::format(R"(# bash completion for morphkit; made by `morphkit completion bash`.
_morphkit_words() {{ mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }}
_morphkit_files() {{
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -- "$word")
}}
_morphkit() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD-1]}}" command='' i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "${{COMP_WORDS[i]}}" in
      {}) command="${{COMP_WORDS[i]}}"; break ;;
    esac
  done
  COMPREPLY=()
  case "$command $previous" in
{}  esac
  case "$command" in
{}  esac
}}
complete -F _morphkit morphkit
)",
                     joined(command_names(program), "|"), values, words);
}

std::string zsh_completion(const CommandShape& program) {
  std::string descriptions;
  std::string branches;
  for (const CommandShape& command : program.commands) {
    descriptions += fmt::format("        {}\n", quoted(zsh_text(command.name) + ":" + zsh_text(command.description)));
    const std::string rest = command.positional_choices.empty()
                                 ? std::string("'*:file:_files'")
                                 : fmt::format("'*:argument:({})'", joined(command.positional_choices, " "));
    branches += fmt::format("        {}) _arguments -s{} \\\n          {} ;;\n", command.name,
                            zsh_arguments(command, "          "), rest);
  }
  return fmt::format(R"(#compdef morphkit
# zsh completion for morphkit; made by `morphkit completion zsh`.
_morphkit() {{
  local state line
  _arguments -C -s{} \
    '1:command:->command' '*::argument:->argument'
  case "$state" in
    command)
      local -a commands=(
{}      )
      _describe command commands ;;
    argument)
      case "$line[1]" in
{}      esac ;;
  esac
}}
if [ "$funcstack[1]" = _morphkit ]; then _morphkit "$@"; else compdef _morphkit morphkit; fi
)",
                     zsh_arguments(program, "    "), descriptions, branches);
}

std::string fish_completion(const CommandShape& program) {
  std::string text = "# fish completion for morphkit; made by `morphkit completion fish`.\n";
  for (const OptionShape& option : program.options) text += fish_option(option, "__fish_use_subcommand");
  for (const CommandShape& command : program.commands) {
    text += fmt::format("complete -c morphkit -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.description));
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    for (const OptionShape& option : command.options) text += fish_option(option, condition);
    if (!command.positional_choices.empty()) {
      text += fmt::format("complete -c morphkit -n {} -f -a {}\n", quoted(condition),
                          quoted(joined(command.positional_choices, " ")));
    }
  }
  return text;
}

}  // namespace morphkit::cli
