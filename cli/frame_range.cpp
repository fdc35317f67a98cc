#include "cli/frame_range.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "cli/exit_code.h"

namespace morphkit::cli {
namespace {

constexpr const char* kForms = "write e.g. 7, 1-240, 1-240x2, 10- or 1,5,9-12";

[[noreturn]] void fail(const std::string& text, const std::string& message) {
  throw ArgumentError(fmt::format("--frames {}", text), message);
}

/// Takes digits from the front of `rest`.
std::int64_t take_number(std::string_view& rest, const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range) fail(text, "a number is too large");
  if (error != std::errc{} || rest.front() == '-') fail(text, fmt::format("not a frame range; {}", kForms));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return number;
}

bool take(std::string_view& rest, char expected) {
  if (rest.empty() || rest.front() != expected) return false;
  rest.remove_prefix(1);
  return true;
}

void add_part(std::string_view part, const std::string& text, int first, int last, std::vector<int>& frames) {
  std::string_view rest = part;
  const std::int64_t begin = take_number(rest, text);
  std::int64_t end = begin;
  std::int64_t step = 1;
  if (take(rest, '-')) {
    end = rest.empty() || rest.front() == 'x' ? last : take_number(rest, text);
    if (take(rest, 'x')) step = take_number(rest, text);
  }
  if (!rest.empty()) fail(text, fmt::format("'{}' is not a frame range; {}", part, kForms));
  if (step < 1) fail(text, fmt::format("'{}' has step 0; the step is at least 1", part));
  // Ends are judged before anything is listed: "1-2000000000" must not fill the memory first.
  for (const std::int64_t frame : {begin, end}) {
    if (frame < first || frame > last) {
      fail(text, fmt::format("frame {} does not exist; the frames are {}-{}", frame, first, last));
    }
  }
  if (end < begin) fail(text, fmt::format("'{}' runs backwards; write {}-{}", part, end, begin));
  for (std::int64_t frame = begin; frame <= end; frame += step) frames.push_back(static_cast<int>(frame));
}

}  // namespace

std::vector<int> parse_frame_range(const std::string& text, int first, int last) {
  if (text.empty()) fail("''", fmt::format("an empty frame range; {}", kForms));
  std::vector<int> frames;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    add_part(rest.substr(0, comma), text, first, last, frames);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}  // namespace morphkit::cli
