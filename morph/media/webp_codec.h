#pragma once
// WebP through libwebp itself. OpenImageIO 2.4 multiplies WebP's colour by alpha in 8 bits on the way in, where the
// hint that stops it for other formats is ignored, and writes every file from chroma at half resolution, lossless ones
// too: neither comes back as it was.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace morphkit::media {

struct WebpHeader {
  int width = 0, height = 0;  ///< px
  bool has_alpha = false;
};

/// @throws Error kBadInput if it is damaged or an animation.
WebpHeader webp_header(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// 8-bit sRGB, RGBA, straight alpha. @throws Error kBadInput if it is damaged or cut short.
std::vector<std::uint8_t> decode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// @param samples   `width * height * channels` samples, RGB or RGBA with straight alpha.
/// @param channels  3 or 4.
/// @param quality   1..99 lossy, 100 lossless.
/// @throws Error kFailed if the encoder gives up.
std::vector<std::uint8_t> encode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> samples,
                                      int width, int height, int channels, int quality);

}  // namespace morphkit::media
