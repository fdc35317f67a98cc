#pragma once
// Finds damage in PNG files before libpng does: libpng prints its messages on stderr, past OpenImageIO.

#include <cstdint>
#include <filesystem>
#include <span>

namespace morphkit::media {

/// Walks the chunks: lengths, checksums, a header of a legal size, an end. Cost: one pass over the bytes.
/// @throws Error kBadInput naming the chunk and the byte where the file is cut or damaged.
void check_png(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

}  // namespace morphkit::media
