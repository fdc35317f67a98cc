#pragma once
// The size of a picture without OpenImageIO, for programs that start quickly.

#include <filesystem>
#include <optional>

#include <opencv2/core/types.hpp>

namespace morphkit::media {

/// The size that read_info tells, if it can be told without the library: of a plain PNG file (no palette, no texts,
/// which may turn a picture). Nothing of all others.
/// @throws Error as read_info if the file is missing, unreadable or a damaged PNG. Cost: reads the whole file.
std::optional<cv::Size> quick_size(const std::filesystem::path& file);

}  // namespace morphkit::media
