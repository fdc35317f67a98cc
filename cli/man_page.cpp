#include "cli/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace morphkit::cli {
namespace {

/// roff reads a backslash as the start of a request in a line, a bare "-" as a hyphen that nobody can copy, and a dot
/// or a quote at the start of a line as a request.
std::string escaped(std::string_view text) {
  std::string result;
  if (text.starts_with('.') || text.starts_with('\'')) result = "\\&";
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else {
      if (c == '-') result += '\\';
      result += c;
    }
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// "morphkit morph" as a page is called: "morphkit-morph".
std::string page_name(std::string command) {
  std::ranges::replace(command, ' ', '-');
  return command;
}

std::string without_indent(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// The sections below the usage: a heading and its lines.
struct Section {
  std::string heading;
  std::vector<std::string> lines;
};

struct Help {
  std::string description;
  std::string usage;  ///< what follows the command
  std::vector<Section> sections;
};

constexpr std::string_view kUsage = "Usage: ";
constexpr std::string_view kExitCodes = "Exit codes: ";

Help split(const ManPage& page) {
  Help help;
  bool is_above_usage = true;
  std::istringstream stream(page.help);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(kUsage)) {
      help.usage = without_indent(line.substr(std::min(kUsage.size() + page.command.size(), line.size())));
      is_above_usage = false;
    } else if (is_above_usage) {
      help.description += (help.description.empty() ? "" : " ") + line;
    } else if (line.starts_with(kExitCodes)) {
      help.sections.push_back({"Exit status", {line.substr(kExitCodes.size())}});
    } else if (!line.empty() && line.front() != ' ' && line.ends_with(':')) {
      help.sections.push_back({line.substr(0, line.size() - 1), {}});
    } else if (!line.empty() && !help.sections.empty()) {
      help.sections.back().lines.push_back(line);
    }
  }
  return help;
}

std::string examples(const Section& section) {
  std::string text = ".nf\n";
  for (const std::string& line : section.lines) text += escaped(without_indent(line)) + '\n';
  return text + ".fi\n";
}

/// "0 done; 1 the work failed": a tagged paragraph for each.
std::string exit_status(const Section& section) {
  std::string all;
  for (const std::string& line : section.lines) all += (all.empty() ? "" : " ") + without_indent(line);
  std::string text;
  std::istringstream stream(all);
  for (std::string part; std::getline(stream, part, ';');) {
    part = without_indent(part);
    const std::size_t space = std::min(part.find(' '), part.size());
    text += ".TP\n.B " + part.substr(0, space) + '\n' + escaped(without_indent(part.substr(space))) + '\n';
  }
  return text;
}

/// Two columns, a name and its text, as tagged paragraphs. A name that leaves no room has its text on the next line.
std::string list(const Section& section) {
  std::string text;
  for (const std::string& line : section.lines) {
    const bool starts_entry = line.starts_with("  ") && line.find_first_not_of(' ') == 2;
    if (!starts_entry) {
      text += escaped(without_indent(line)) + '\n';
      continue;
    }
    const std::size_t gap = std::min(line.find("  ", 2), line.size());
    std::string name = line.substr(2, gap - 2);
    if (const std::size_t comma = name.find(",--"); comma != std::string::npos) name.insert(comma + 1, " ");
    text += ".TP\n.B " + escaped(name) + '\n';
    if (gap < line.size()) text += escaped(without_indent(line.substr(gap))) + '\n';
  }
  return text;
}

std::string see_also(const std::vector<std::string>& commands) {
  std::string text;
  for (const std::string& command : commands) {
    text += (text.empty() ? ".BR " : ",\n.BR ") + escaped(page_name(command)) + " (1)";
  }
  return text + '\n';
}

}  // namespace

std::string to_roff(const ManPage& page) {
  const Help help = split(page);
  const std::string name = page_name(page.command);
  std::string text = ".TH \"" + escaped(upper(name)) + "\" 1 \"\" \"morphkit " + page.version +
                     "\" \"User Commands\"\n" + ".SH NAME\n" + escaped(name) + " \\- " + escaped(help.description) +
                     "\n.SH SYNOPSIS\n.B " + escaped(page.command) + '\n' + escaped(help.usage) + '\n';
  for (const Section& section : help.sections) {
    const bool is_example = section.heading == "Example";
    text += ".SH \"" + (is_example ? "EXAMPLES" : upper(section.heading)) + "\"\n";
    text += is_example ? examples(section) : section.heading == "Exit status" ? exit_status(section) : list(section);
  }
  if (!page.see_also.empty()) text += ".SH \"SEE ALSO\"\n" + see_also(page.see_also);
  return text;
}

}  // namespace morphkit::cli
