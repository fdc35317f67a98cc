#pragma once
// How help texts look: the command's own options first, what all commands share last, lines of 80 columns.

#include <memory>
#include <string>

namespace CLI {
class FormatterBase;
}

namespace morphkit::cli {

inline constexpr const char* kCommonGroup = "Common options";

std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Breaks `text` at spaces into lines of at most `columns` characters (a longer word stays whole).
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace morphkit::cli
