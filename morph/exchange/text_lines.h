#pragma once
// Text files of other tools, line by line. Internal to morph/exchange.

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <opencv2/core/types.hpp>

namespace morphkit::exchange {

/// The lines of a file. The text outlives it.
class TextLines {
 public:
  /// @param name  of the file, for messages.
  TextLines(std::string_view text, std::string name);

  /// The next line that is not blank, without its end and surrounding space; nullopt at the end of the file.
  std::optional<std::string_view> next();

  /// @throws Error kBadInput at the last line read.
  [[noreturn]] void fail(const std::string& message) const;

  /// "file:line" of the last line read.
  std::string place() const;

 private:
  std::string_view rest_;
  std::string name_;
  int number_ = 0;
};

/// The words of a line; everything after the first `most` words is one word.
std::vector<std::string_view> words_of(std::string_view line, std::size_t most);

/// The number that the word is, as a whole.
template <typename T>
std::optional<T> number_in(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The whole next line as `count` numbers, each within project::kMaxCoordinate. @param tag  the line before, for the
/// message. @throws Error kBadInput if it is something else.
std::vector<double> read_numbers(TextLines& lines, std::size_t count, std::string_view tag);

/// Width and height. @throws Error kBadInput also below 2 x 2.
cv::Size2d read_size(TextLines& lines, std::string_view tag);

}  // namespace morphkit::exchange
