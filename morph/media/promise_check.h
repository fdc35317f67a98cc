#pragma once
// Headers of GIF, BMP, DPX and PSD files that promise more than there is: OpenImageIO allocates what they say when it
// opens the file.

#include <filesystem>
#include <string>

namespace morphkit::media {

/// Looks at width, height and the lengths of what stands before the pixels; does nothing for other formats. Cost: a few
/// reads of the headers; nothing is allocated.
/// @param format  as sniff_format gives it.
/// @throws Error kBadInput with the size that is beyond the limits of image_format.h, or the length and the byte where
///     it is promised if the file has no room for it.
void check_promises(const std::filesystem::path& file, const std::string& format);

}  // namespace morphkit::media
