#pragma once
// File names with a place for the frame number.

#include <filesystem>
#include <string>
#include <string_view>

namespace morphkit::media {

/// "frame.%04d.png", "frame.####.png": a file name with a place for the frame number.
///
/// The place is `%d` (no padding), `%0Nd` (at least N digits, zero padded) or a run of N `#` (the same as `%0Nd`); a
/// minus sign counts as a digit, as in printf. `%%` stands for one `%`. Only the last component of the path is a
/// pattern: folders are taken literally.
class FramePattern {
 public:
  /// @throws Error kUnsupported if the name has no place for a number, more than one, or a `%` without meaning.
  explicit FramePattern(const std::filesystem::path& name);

  /// Whether the file name has at least one place for a number. Never throws for a malformed name.
  static bool matches(const std::filesystem::path& name);

  /// The file of one frame, any int.
  std::filesystem::path operator()(int frame) const;

  /// Whether a name (without folder) is that of some frame.
  bool names(std::string_view name) const;

 private:
  std::filesystem::path folder_;
  std::string prefix_;
  std::string suffix_;
  int width_ = 0;
};

}  // namespace morphkit::media
