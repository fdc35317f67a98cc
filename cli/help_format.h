#pragma once
// The format of help texts: the command's own options first, common options last, lines of 80 columns.

#include <memory>
#include <string>

namespace CLI {
class FormatterBase;
}

namespace morphkit::cli {

inline constexpr const char* kCommonGroup = "Common options";

std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Breaks `text` at spaces into lines of at most `columns` characters. A longer word stays whole.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace morphkit::cli
