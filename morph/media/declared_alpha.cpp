#include "morph/media/declared_alpha.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace morphkit::media {
namespace {

/// Numbers and bytes of a file at given places; what lies beyond the end reads as nothing.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    stream_.seekg(0, std::ios::end);
    size_ = stream_ ? static_cast<std::int64_t>(stream_.tellg()) : 0;
  }

  std::int64_t size() const { return size_; }

  std::string at(std::int64_t place, std::size_t count) {
    if (place < 0 || place >= size_) return "";
    std::string bytes(count, '\0');
    stream_.clear();
    stream_.seekg(place);
    stream_.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream_.gcount()));
    return bytes;
  }

  /// Little-endian; 0 beyond the end.
  std::uint32_t number(std::int64_t place, std::size_t count) {
    const std::string bytes = at(place, count);
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size() == count ? count : 0; i > 0; --i)
      value = value << 8 | static_cast<std::uint8_t>(bytes[i - 1]);
    return value;
  }

 private:
  std::ifstream stream_;
  std::int64_t size_ = 0;
};

DeclaredAlpha of_bmp(Bytes& file) {
  constexpr std::uint32_t kShortestWithMask = 56;  // BITMAPV3INFOHEADER
  constexpr std::uint32_t kBitfields = 3, kAlphaBitfields = 6;
  const std::uint32_t header = file.number(14, 4);
  const std::uint32_t compression = file.number(30, 4);
  if (file.number(28, 2) != 32) return DeclaredAlpha::kNone;
  const bool has_masks = compression == kBitfields || compression == kAlphaBitfields;
  if (has_masks && (header >= kShortestWithMask || compression == kAlphaBitfields) && file.number(66, 4) != 0)
    return DeclaredAlpha::kStraight;
  constexpr std::size_t kPiece = 1 << 16;
  for (std::int64_t place = file.number(10, 4); place < file.size(); place += kPiece) {
    const std::string pixels = file.at(place, kPiece);
    for (std::size_t i = 3; i < pixels.size(); i += 4)
      if (pixels[i] != 0) return DeclaredAlpha::kStraight;
  }
  return DeclaredAlpha::kNone;
}

DeclaredAlpha of_tga(Bytes& file) {
  constexpr std::int64_t kFooter = 26, kAttributesType = 494;
  constexpr std::string_view kSignature = "TRUEVISION-XFILE.";
  constexpr std::uint32_t kAlphaBits = 0x0F, kUseful = 3, kAssociated = 4;
  const std::int64_t footer = file.size() - kFooter;
  const std::uint32_t extension = file.at(footer + 8, kSignature.size()) == kSignature ? file.number(footer, 4) : 0;
  if (extension != 0) {
    const std::uint32_t type = file.number(extension + kAttributesType, 1);
    if (type == kAssociated) return DeclaredAlpha::kPremultiplied;
    return type == kUseful ? DeclaredAlpha::kStraight : DeclaredAlpha::kNone;
  }
  return (file.number(17, 1) & kAlphaBits) != 0 ? DeclaredAlpha::kStraight : DeclaredAlpha::kNone;
}

}  // namespace

DeclaredAlpha declared_alpha(const std::filesystem::path& file, const std::string& format) {
  if (format != "bmp" && format != "targa") return DeclaredAlpha::kLibraryKnows;
  Bytes bytes(file);
  return format == "bmp" ? of_bmp(bytes) : of_tga(bytes);
}

}  // namespace morphkit::media
