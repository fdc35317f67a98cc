#include "morph/exchange/text_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "morph/json/json.h"
#include "morph/project/limits.h"

namespace morphkit::exchange {
namespace {

std::string_view trimmed(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r\f\v";
  const std::size_t begin = line.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

std::optional<std::string_view> TextLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    if (!line.empty()) return line;
  }
  return std::nullopt;
}

void TextLines::fail(const std::string& message) const {
  throw Error(ErrorKind::kBadInput, place(), message);
}

std::string TextLines::place() const {
  return fmt::format("{}:{}", name_, std::max(number_, 1));
}

std::vector<std::string_view> words_of(std::string_view line, std::size_t most) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = words.size() + 1 < most ? line.find_first_of(" \t") : std::string_view::npos;
    words.push_back(line.substr(0, end));
    line.remove_prefix(words.back().size());
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  return words;
}

std::vector<double> read_numbers(TextLines& lines, std::size_t count, std::string_view tag) {
  const std::optional<std::string_view> line = lines.next();
  std::vector<double> numbers;
  if (line) {
    for (const std::string_view word : words_of(*line, count + 1)) {
      const std::optional<double> number = number_in<double>(word);
      if (number && std::abs(*number) <= project::kMaxCoordinate) numbers.push_back(*number);  // also refuses NaN
    }
  }
  if (numbers.size() != count || words_of(*line, count + 1).size() != count) {
    lines.fail(fmt::format("expected {} numbers after {}, found {}", count, tag,
                           line ? json::shown(*line) : "the end of the file"));
  }
  return numbers;
}

cv::Size2d read_size(TextLines& lines, std::string_view tag) {
  const std::vector<double> numbers = read_numbers(lines, 2, tag);
  if (numbers[0] < 2 || numbers[1] < 2) lines.fail(fmt::format("{} is too small; expected at least 2 2", tag));
  return {numbers[0], numbers[1]};
}

}  // namespace morphkit::exchange
