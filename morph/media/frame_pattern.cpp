#include "morph/media/frame_pattern.h"

#include <cctype>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit::media {
namespace {

/// More digits than any int needs, but short enough for every file system.
constexpr int kMaxWidth = 32;

/// A place for the number at the start of some text.
struct Place {
  std::size_t length;  ///< characters of the place
  int width;           ///< least number of digits; invalid if above kMaxWidth
};

std::optional<Place> place_at(std::string_view text) {
  const std::size_t hashes = std::min(text.find_first_not_of('#'), text.size());
  if (hashes > 0) return Place{hashes, hashes > kMaxWidth ? kMaxWidth + 1 : static_cast<int>(hashes)};
  if (text.empty() || text[0] != '%') return std::nullopt;
  std::size_t i = 1;
  int width = 0;
  if (i < text.size() && text[i] == '0') {
    for (++i; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0; ++i)
      width = std::min(width * 10 + (text[i] - '0'), kMaxWidth + 1);
  }
  if (i >= text.size() || text[i] != 'd') return std::nullopt;
  return Place{i + 1, width};
}

[[noreturn]] void refuse(const std::filesystem::path& name, const std::string& problem) {
  throw Error(ErrorKind::kUnsupported, name.string(),
              problem + "; write one place for the frame number, such as frame.%04d.png or frame.####.png");
}

}  // namespace

FramePattern::FramePattern(const std::filesystem::path& name) : folder_(name.parent_path()) {
  const std::string file = name.filename().string();
  bool found = false;
  std::string* part = &prefix_;
  for (std::size_t i = 0; i < file.size();) {
    const std::string_view rest = std::string_view(file).substr(i);
    if (const auto place = place_at(rest)) {
      if (found) refuse(name, "has more than one place for the frame number");
      if (place->width > kMaxWidth) refuse(name, fmt::format("asks for more than {} digits", kMaxWidth));
      found = true;
      width_ = place->width;
      part = &suffix_;
      i += place->length;
    } else if (rest.starts_with("%%")) {
      part->push_back('%');
      i += 2;
    } else if (rest.starts_with('%')) {
      refuse(name,
             fmt::format("'{}' is not a frame number (%d, %04d, ####) nor a percent sign (%%)", rest.substr(0, 3)));
    } else {
      part->push_back(rest[0]);
      ++i;
    }
  }
  if (!found) refuse(name, "has no place for the frame number");
}

bool FramePattern::matches(const std::filesystem::path& name) {
  const std::string file = name.filename().string();
  for (std::size_t i = 0; i < file.size();) {
    const std::string_view rest = std::string_view(file).substr(i);
    if (place_at(rest)) return true;
    i += rest.starts_with("%%") ? 2 : 1;
  }
  return false;
}

std::filesystem::path FramePattern::operator()(int frame) const {
  return folder_ / fmt::format("{}{:0{}}{}", prefix_, frame, width_, suffix_);
}

bool FramePattern::names(std::string_view name) const {
  if (name.size() <= prefix_.size() + suffix_.size() || !name.starts_with(prefix_) || !name.ends_with(suffix_)) {
    return false;
  }
  const std::string_view digits = name.substr(prefix_.size(), name.size() - prefix_.size() - suffix_.size());
  int frame = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), frame);
  return error == std::errc() && (folder_ / name) == (*this)(frame);
}

}  // namespace morphkit::media
