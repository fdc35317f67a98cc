#include "morph/media/guard/png_check.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cctype>
#include <string>

#include "base/error.h"
#include "morph/media/image_format.h"

namespace morphkit::media {
namespace {

// PNG (ISO/IEC 15948), clause 5: an 8-byte signature, then chunks of length, type, data, CRC-32 of type and data.
constexpr std::size_t kSignature = 8;
constexpr std::size_t kLengthAndType = 8;
constexpr std::size_t kChecksum = 4;
constexpr std::size_t kHeaderData = 13;

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

std::string chunk_type(std::span<const std::uint8_t> bytes) {
  std::string type;
  for (const std::uint8_t byte : bytes.first(4)) type += std::isalpha(byte) != 0 ? static_cast<char>(byte) : '?';
  return type;
}

}  // namespace

void check_png(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const auto fail = [&](const std::string& message) { throw Error(ErrorKind::kBadInput, file.string(), message); };
  std::size_t position = kSignature;
  for (bool first = true;; first = false) {
    if (bytes.size() < position + kLengthAndType) {
      fail(fmt::format("the PNG file is cut short: it ends at byte {} without an end mark", bytes.size()));
    }
    const std::size_t length = big_endian(bytes.subspan(position, 4));
    const std::string type = chunk_type(bytes.subspan(position + 4));
    const std::size_t end = position + kLengthAndType + length + kChecksum;
    if (bytes.size() < end) {
      fail(fmt::format("the PNG file is cut short: chunk {} at byte {} needs {} bytes, {} are left", type, position,
                       end - position, bytes.size() - position));
    }
    const auto checked = bytes.subspan(position + 4, 4 + length);
    if (::crc32_z(0, checked.data(), checked.size()) != big_endian(bytes.subspan(end - kChecksum))) {
      fail(fmt::format("the PNG file is damaged: chunk {} at byte {} has a wrong checksum", type, position));
    }
    if (first != (type == "IHDR") || (first && length != kHeaderData)) {
      fail("the PNG file is damaged: it does not begin with its header");
    }
    if (first) check_size(file, big_endian(checked.subspan(4)), big_endian(checked.subspan(8)), 1);
    if (type == "IEND") return;
    position = end;
  }
}

}  // namespace morphkit::media
