#include "morph/media/guard/exr_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "morph/media/image_format.h"

namespace morphkit::media {
namespace {

// "OpenEXR File Layout": magic number, version and flags, headers, tables of chunk offsets, chunks; little endian. A
// header is attributes (name, type, both ended by a zero, int32 size, value), then an empty name.
constexpr std::uint32_t kMagic = 0x01312f76;
constexpr std::uint32_t kVersionMask = 0xff;
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kMultiPart = 0x1000;
constexpr std::int64_t kLongestName = 255;    // OpenEXR's limit; 31 for files without the long-names flag
constexpr std::int64_t kChannelNumbers = 16;  // type, linearity and padding, two sampling rates
constexpr std::uint32_t kPixelTypes = 3;      // uint, half, float
constexpr std::int64_t kChunkOffset = 8;      // bytes of a table entry

/// OpenEXR holds a whole tile in memory, even for a small picture: 4096 x 4096 pixels of RGBA are fine.
constexpr std::int64_t kUsualTileSamples = std::int64_t{1} << 26;

struct FixedType {
  std::string_view name;
  std::int64_t size;  ///< bytes
};

/// OpenEXR ignores the size of these attributes, reads this many bytes and continues after them. With another size, it
/// would see other attributes than this check.
constexpr std::array kFixedTypes = {
    FixedType{"box2f", 16},
    FixedType{"box2i", 16},
    FixedType{"chromaticities", 32},
    FixedType{"compression", 1},
    FixedType{"deepImageState", 1},
    FixedType{"double", 8},
    FixedType{"envmap", 1},
    FixedType{"float", 4},
    FixedType{"int", 4},
    FixedType{"keycode", 28},
    FixedType{"lineOrder", 1},
    FixedType{"m33d", 72},
    FixedType{"m33f", 36},
    FixedType{"m44d", 128},
    FixedType{"m44f", 64},
    FixedType{"rational", 8},
    FixedType{"tiledesc", 9},
    FixedType{"timecode", 8},
    FixedType{"v2d", 16},
    FixedType{"v2f", 8},
    FixedType{"v2i", 8},
    FixedType{"v3d", 24},
    FixedType{"v3f", 12},
    FixedType{"v3i", 12},
};

struct Attribute {
  std::string name, type;
  std::int64_t begin = 0;  ///< byte of the file where its name begins
  std::int64_t end = 0;    ///< byte after its value
};

struct Size {
  std::int64_t width = 0, height = 0;
};

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::isprint(c) == 0; }, '?');
  return text;
}

class ExrHeader {
 public:
  explicit ExrHeader(const std::filesystem::path& file)
      : file_(file),
        stream_(file, std::ios::binary),
        size_(static_cast<std::int64_t>(std::filesystem::file_size(file))) {}

  void check() {
    if (read_u32() != kMagic) fail("is not an EXR file");
    const std::uint32_t version = read_u32();
    if ((version & kVersionMask) != kVersion) {
      fail(fmt::format("is an EXR file of version {}; only version {} can be read", version & kVersionMask, kVersion));
    }
    const bool is_multi_part = (version & kMultiPart) != 0;
    while (check_part() && is_multi_part) {
    }
    if (chunks_ > (size_ - position_) / kChunkOffset) {
      fail(fmt::format("the EXR file is damaged or cut short: it promises {} chunks, {} bytes are left", chunks_,
                       size_ - position_));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::kBadInput, file_.string(), message);
  }

  [[noreturn]] void fail(const Attribute& attribute, const std::string& reason) const {
    fail(fmt::format("the EXR file is damaged: attribute {} ({}) at byte {} {}", attribute.name, attribute.type,
                     attribute.begin, reason));
  }

  int read_byte() {
    const int byte = stream_.get();
    if (byte == std::ifstream::traits_type::eof()) {
      fail(fmt::format("the EXR file is cut short: it ends at byte {}, within its header", position_));
    }
    ++position_;
    return byte;
  }

  std::uint32_t read_u32() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8) value |= static_cast<std::uint32_t>(read_byte()) << shift;
    return value;
  }

  std::int64_t read_i32() { return std::bit_cast<std::int32_t>(read_u32()); }

  std::string read_name() {
    const std::int64_t begin = position_;
    std::string name;
    for (int byte = read_byte(); byte != 0; byte = read_byte()) {
      name += static_cast<char>(byte);
      if (position_ - begin > kLongestName) {
        fail(fmt::format("the EXR file is damaged: the name at byte {} is longer than {} bytes", begin, kLongestName));
      }
    }
    return printable(name);
  }

  void skip_to(std::int64_t position) {
    stream_.seekg(position);
    position_ = position;
  }

  /// Checks one header; false at the end of the list of headers.
  bool check_part() {
    bool is_empty = true;
    picture_ = tile_ = {};
    channels_ = 0;
    for (Attribute attribute; next(attribute); is_empty = false) {
      check_value(attribute);
      skip_to(attribute.end);
    }
    check_tile();
    return !is_empty;
  }

  bool next(Attribute& attribute) {
    attribute.begin = position_;
    attribute.name = read_name();
    if (attribute.name.empty()) return false;
    attribute.type = read_name();
    const std::int64_t length = read_i32();
    const std::int64_t left = size_ - position_;
    attribute.end = position_ + length;
    if (length < 0 || length > left) fail(attribute, fmt::format("needs {} bytes, {} are left", length, left));
    return true;
  }

  void check_value(const Attribute& attribute) {
    const std::int64_t length = attribute.end - position_;
    const auto* fixed = std::find_if(kFixedTypes.begin(), kFixedTypes.end(),
                                     [&](const FixedType& type) { return type.name == attribute.type; });
    if (fixed != kFixedTypes.end() && fixed->size != length) {
      fail(attribute, fmt::format("has {} bytes instead of {}", length, fixed->size));
    }
    if (attribute.type == "floatvector" && length % 4 != 0) {
      fail(attribute, fmt::format("has {} bytes, which is no multiple of 4", length));
    }
    if (attribute.type == "chlist") check_channels(attribute);
    if (attribute.type == "stringvector") check_strings(attribute);
    if (attribute.type == "preview") check_preview(attribute);
    if (attribute.name == "dataWindow" && attribute.type == "box2i") picture_ = check_window();
    if (attribute.name == "displayWindow" && attribute.type == "box2i") check_window();
    if (attribute.name == "tiles" && attribute.type == "tiledesc") tile_ = {read_u32(), read_u32()};
    if (attribute.name == "chunkCount" && attribute.type == "int") count_chunks(attribute);
  }

  void check_channels(const Attribute& attribute) {
    channels_ = 0;
    while (!read_name().empty()) {
      ++channels_;
      if (position_ + kChannelNumbers >= attribute.end) fail(attribute, "has a list without an end");
      const std::int64_t end = position_ + kChannelNumbers;
      const std::uint32_t type = read_u32();
      // If the type of a part is unknown, OpenEXR accepts this and OpenImageIO aborts.
      if (type >= kPixelTypes) fail(attribute, fmt::format("has a channel of the unknown pixel type {}", type));
      skip_to(end);
    }
    if (position_ != attribute.end) fail(attribute, "has a list that ends before or behind its bytes");
    check_size(file_, 1, 1, channels_);
  }

  void check_strings(const Attribute& attribute) {
    while (position_ < attribute.end) {
      if (attribute.end - position_ < 4) fail(attribute, "ends within the length of a string");
      const std::int64_t length = read_i32();
      const std::int64_t left = attribute.end - position_;
      if (length < 0 || length > left) {
        fail(attribute, fmt::format("has a string of {} bytes where {} are left", length, left));
      }
      skip_to(position_ + length);
    }
  }

  void check_preview(const Attribute& attribute) {
    if (attribute.end - position_ < 8) fail(attribute, "is too short for its width and height");
    const std::int64_t width = read_u32();
    const std::int64_t height = read_u32();
    const std::int64_t pixels = (attribute.end - position_) / 4;
    const bool fits = width == 0 || height == 0 ? pixels == 0 : height <= pixels / width && width * height == pixels;
    if (!fits || (attribute.end - position_) % 4 != 0) {
      fail(attribute,
           fmt::format("promises {} x {} pixels and has {} bytes", width, height, attribute.end - position_));
    }
  }

  Size check_window() {
    const std::int64_t left = read_i32();
    const std::int64_t top = read_i32();
    const std::int64_t right = read_i32();
    const std::int64_t bottom = read_i32();
    const Size size{right - left + 1, bottom - top + 1};
    check_size(file_, size.width, size.height, 1);
    return size;
  }

  void check_tile() const {
    if (tile_.width == 0) return;
    const std::int64_t most =
        std::max(kUsualTileSamples / std::max<std::int64_t>(channels_, 1), 4 * picture_.width * picture_.height);
    if (tile_.width > most || tile_.height > most || tile_.width * tile_.height > most) {
      fail(fmt::format("the EXR file is damaged: it promises tiles of {} x {} pixels for a picture of {} x {}",
                       tile_.width, tile_.height, picture_.width, picture_.height));
    }
  }

  void count_chunks(const Attribute& attribute) {
    const std::int64_t count = read_i32();
    if (count < 0) fail(attribute, fmt::format("promises {} chunks", count));
    chunks_ += count;
  }

  std::filesystem::path file_;
  std::ifstream stream_;
  std::int64_t size_ = 0;      ///< bytes of the file
  std::int64_t position_ = 0;  ///< the next byte to read
  std::int64_t chunks_ = 0;    ///< of all parts
  Size picture_, tile_;        ///< of this part; px
  std::int64_t channels_ = 0;  ///< of this part
};

}  // namespace

void check_exr(const std::filesystem::path& file) {
  ExrHeader(file).check();
}

}  // namespace morphkit::media
