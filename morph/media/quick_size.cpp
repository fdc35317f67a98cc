#include "morph/media/quick_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "morph/media/image_format.h"
#include "morph/media/png_check.h"

namespace morphkit::media {
namespace {

std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// Truecolour or grey of 8 or 16 bits, in the one compression and filter method that there is.
bool is_plain_header(const std::uint8_t* data) {
  const int depth = data[8], colour = data[9];
  return (depth == 8 || depth == 16) && (colour == 0 || colour == 2 || colour == 4 || colour == 6) && data[10] == 0 &&
         data[11] == 0 && data[12] <= 1;
}

/// Chunks that say nothing of which way is up.
bool is_plain_chunk(std::string_view type) {
  constexpr std::array<std::string_view, 10> kPlain = {"IHDR", "IDAT", "IEND", "gAMA", "cHRM",
                                                       "sRGB", "pHYs", "sBIT", "bKGD", "tIME"};
  for (const std::string_view plain : kPlain)
    if (type == plain) return true;
  return false;
}

}  // namespace

std::optional<cv::Size> quick_size(const std::filesystem::path& file) {
  if (sniff_format(file) != "png") return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return std::nullopt;
  check_png(file, bytes);

  constexpr std::size_t kSignature = 8, kAroundData = 12;
  const std::uint8_t* const header = &bytes[kSignature + 8];
  bool has_pixels = false;
  for (std::size_t at = kSignature;; at += kAroundData + big_endian(&bytes[at])) {
    const std::string_view type(reinterpret_cast<const char*>(&bytes[at + 4]), 4);
    if (!is_plain_chunk(type)) return std::nullopt;
    has_pixels = has_pixels || type == "IDAT";
    if (type == "IEND") break;
  }
  if (!has_pixels || !is_plain_header(header)) return std::nullopt;
  return cv::Size(static_cast<int>(big_endian(header)), static_cast<int>(big_endian(header + 4)));
}

}  // namespace morphkit::media
