#pragma once
// WebP through libwebp itself. OpenImageIO 2.4 premultiplies WebP in 8 bits when it reads, and ignores the hint that
// stops this for other formats. When it writes, it halves the resolution of chroma, even for lossless files. Both lose
// data.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace morphkit::media {

struct WebpHeader {
  int width = 0, height = 0;  ///< px
  bool has_alpha = false;
};

/// @throws Error kBadInput if it is damaged; kUnsupported if it is an animation.
WebpHeader webp_header(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// The ICC profile in the file; empty if there is none.
std::span<const std::uint8_t> webp_profile(std::span<const std::uint8_t> bytes);

/// The orientation by the Exif data in the file, 1 to 8; 1 if there are none.
int webp_orientation(std::span<const std::uint8_t> bytes);

/// 8-bit, unpremultiplied RGBA. @throws Error kBadInput if it is damaged or cut short.
std::vector<std::uint8_t> decode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// @param samples   `width * height * channels` samples, RGB or unpremultiplied RGBA.
/// @param channels  3 or 4.
/// @param quality   1..99 lossy, 100 lossless.
/// @throws Error kFailed if the encoder fails.
std::vector<std::uint8_t> encode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> samples,
                                      int width, int height, int channels, int quality);

}  // namespace morphkit::media
