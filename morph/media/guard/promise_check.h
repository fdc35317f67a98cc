#pragma once
// Checks the headers of GIF, BMP, DPX and PSD files for sizes beyond the file: OpenImageIO allocates the sizes in the
// header when it opens the file.

#include <filesystem>
#include <string>

namespace morphkit::media {

/// Checks width, height and the lengths of the blocks before the pixels; does nothing for other formats. Cost: a few
/// reads of the headers, no allocation.
/// @param format  from sniff_format.
/// @throws Error kBadInput with a size beyond the limits of image_format.h, or a length beyond the end of the file and
///     the byte where it stands.
void check_promises(const std::filesystem::path& file, const std::string& format);

}  // namespace morphkit::media
