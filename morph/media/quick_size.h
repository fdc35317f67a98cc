#pragma once
// The size of a picture without OpenImageIO, for programs that start quickly.

#include <filesystem>
#include <optional>

#include <opencv2/core/types.hpp>

namespace morphkit::media {

/// The size that read_info tells, upright, if it can be told without the library: of an ordinary PNG file (no palette)
/// or JPEG file (baseline or progressive, grey or three colours) that says nowhere but in Exif data which way is up.
/// Nothing of all others.
/// @throws Error as read_info if the file is missing, unreadable or a damaged PNG. Cost: reads the whole PNG file, the
/// first MB of a JPEG file.
std::optional<cv::Size> quick_size(const std::filesystem::path& file);

}  // namespace morphkit::media
