#include "cli/arguments.h"

#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "cli/exit_code.h"
#include "morph/project/limits.h"

namespace morphkit::cli {
namespace {

std::optional<int> positive_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

}  // namespace

cv::Size parse_size(const std::string& text, const std::string& option) {
  const std::size_t cross = text.find('x');
  const std::string_view whole = text;
  const auto width = positive_number(whole.substr(0, cross));
  const auto height = cross == std::string::npos ? std::nullopt : positive_number(whole.substr(cross + 1));
  if (!width || !height)
    throw ArgumentError(option, fmt::format("'{}' is no size; write WIDTHxHEIGHT, as in 1280x720", text));
  const double area = static_cast<double>(*width) * *height;
  if (*width > project::kMaxSize || *height > project::kMaxSize || area > project::kMaxArea)
    throw ArgumentError(option, fmt::format("'{}' is too large; at most {} pixels a side and {:.0f} megapixels in all",
                                            text, project::kMaxSize, project::kMaxArea / 1e6));
  return {*width, *height};
}

void require_moment(double t) {
  if (t >= 0 && t <= 1) return;
  throw ArgumentError("-t", fmt::format("{} is no moment; 0 is the source, 1 the destination", t));
}

}  // namespace morphkit::cli
