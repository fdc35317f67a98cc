#include "morph/media/exif_orientation.h"

#include <cstddef>

namespace morphkit::media {
namespace {

/// Numbers in the byte order of the data. Places beyond the end are the caller's to avoid.
struct Numbers {
  std::span<const std::uint8_t> bytes;
  bool is_big = false;

  std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[at + (is_big ? i : size - 1 - i)];
    return value;
  }
};

}  // namespace

std::optional<int> exif_orientation(std::span<const std::uint8_t> tiff) {
  constexpr std::size_t kHeader = 8, kEntry = 12;
  constexpr std::uint32_t kOrientation = 0x0112, kShort = 3, kTiff = 42;
  if (tiff.size() < kHeader || tiff[0] != tiff[1] || (tiff[0] != 'I' && tiff[0] != 'M')) return std::nullopt;
  const Numbers data{tiff, tiff[0] == 'M'};
  const std::size_t directory = data.number(4, 4);
  if (data.number(2, 2) != kTiff || directory > tiff.size() - 2) return std::nullopt;
  const std::size_t entries = data.number(directory, 2);
  if (entries * kEntry > tiff.size() - 2 - directory) return std::nullopt;
  std::optional<int> orientation;
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + i * kEntry;
    if (data.number(at, 2) != kOrientation) continue;
    if (orientation || data.number(at + 2, 2) != kShort || data.number(at + 4, 4) != 1) return std::nullopt;
    const auto value = static_cast<int>(data.number(at + 8, 2));
    orientation = value >= 1 && value <= 8 ? value : 1;
  }
  return orientation.value_or(1);
}

}  // namespace morphkit::media
