#pragma once
// Finds lies in the header of EXR files before OpenEXR does: it allocates what an attribute claims, then reads.

#include <filesystem>

namespace morphkit::media {

/// Walks the headers of all parts: names, sizes of attributes, windows, channels, tiles, counts of chunks. Nothing is
/// allocated and no pixel is read. Cost: of the headers alone.
/// @throws Error kBadInput naming the attribute and the byte where the file is cut or damaged, or the size that is more
///     than the limits of image_format.h.
/// OpenEXR, "OpenEXR File Layout": https://openexr.com/en/latest/OpenEXRFileLayout.html
void check_exr(const std::filesystem::path& file);

}  // namespace morphkit::media
