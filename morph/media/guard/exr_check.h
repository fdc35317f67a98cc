#pragma once
// Checks the headers of EXR files before OpenEXR, which allocates the size that an attribute claims, then reads.

#include <filesystem>

namespace morphkit::media {

/// Walks the headers of all parts: names, sizes of attributes, windows, channels, tiles, counts of chunks. It allocates
/// nothing and reads no pixels. Cost: O(size of the headers).
/// @throws Error kBadInput naming the attribute and the byte where the file is cut or damaged, or a size beyond the
///     limits of image_format.h.
/// OpenEXR, "OpenEXR File Layout": https://openexr.com/en/latest/OpenEXRFileLayout.html
void check_exr(const std::filesystem::path& file);

}  // namespace morphkit::media
