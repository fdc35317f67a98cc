#include "morph/media/quick_size.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/words.h"
#include "morph/media/exif_orientation.h"
#include "morph/media/guard/png_check.h"
#include "morph/media/image_format.h"

namespace morphkit::media {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::uint32_t big_endian(Bytes bytes, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[i];
  return value;
}

std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The first `most` bytes. Nothing if the file cannot be read.
std::optional<std::vector<std::uint8_t>> head_of(const std::filesystem::path& file, std::uintmax_t most) {
  std::error_code error;
  const std::uintmax_t size = std::min(std::filesystem::file_size(file, error), most);
  if (error) return std::nullopt;
  std::vector<std::uint8_t> bytes(size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) return std::nullopt;
  return bytes;
}

/// Width and height change places where the picture lies on its side.
cv::Size upright(cv::Size stored, int orientation) {
  constexpr int kFirstTurned = 5;
  return orientation < kFirstTurned ? stored : cv::Size(stored.height, stored.width);
}

/// Truecolour or grey of 8 or 16 bits, in the one compression and filter method that there is.
bool is_plain_header(Bytes data) {
  const int depth = data[8], colour = data[9];
  return (depth == 8 || depth == 16) && (colour == 0 || colour == 2 || colour == 4 || colour == 6) && data[10] == 0 &&
         data[11] == 0 && data[12] <= 1;
}

/// Texts that OpenImageIO takes for more than a text.
bool is_plain_text(Bytes data) {
  const std::string_view text = text_of(data);
  const std::string keyword = lower(text.substr(0, text.find('\0')));
  return keyword != "orientation" && keyword != "xml:com.adobe.xmp" && keyword != "raw profile type exif";
}

/// Whether a chunk says nothing of which way is up.
bool is_plain_chunk(std::string_view type, Bytes data) {
  constexpr std::array<std::string_view, 12> kPlain = {"IHDR", "IDAT", "IEND", "gAMA", "cHRM", "sRGB",
                                                       "iCCP", "pHYs", "oFFs", "sBIT", "bKGD", "tIME"};
  if (type == "tEXt" || type == "zTXt" || type == "iTXt") return is_plain_text(data);
  return std::ranges::find(kPlain, type) != kPlain.end();
}

/// PNG (ISO/IEC 15948), clause 5, of a file that check_png has passed.
std::optional<cv::Size> png_size(Bytes bytes) {
  constexpr std::size_t kSignature = 8, kLengthAndType = 8, kAroundData = 12;
  const Bytes header = bytes.subspan(kSignature + kLengthAndType);
  bool has_pixels = false;
  int orientation = 1;
  std::string_view type;
  for (std::size_t at = kSignature; type != "IEND";) {
    type = text_of(bytes.subspan(at + 4, 4));
    const Bytes data = bytes.subspan(at + kLengthAndType, big_endian(bytes.subspan(at), 4));
    if (type == "eXIf") {
      const std::optional<int> says = exif_orientation(data);
      if (!says) return std::nullopt;
      orientation = *says;
    } else if (!is_plain_chunk(type, data)) {
      return std::nullopt;
    }
    has_pixels = has_pixels || type == "IDAT";
    at += kAroundData + data.size();
  }
  if (!has_pixels || !is_plain_header(header)) return std::nullopt;
  return upright({static_cast<int>(big_endian(header, 4)), static_cast<int>(big_endian(header.subspan(4), 4))},
                 orientation);
}

/// The segments of a JPEG file up to its pixels (ITU T.81, annex B).
class JpegHeader {
 public:
  std::optional<cv::Size> size_of(Bytes bytes) {
    constexpr std::size_t kMarker = 2, kStartOfScan = 0xda;
    for (std::size_t at = kMarker; at + 4 <= bytes.size();) {
      if (bytes[at] != 0xff) return std::nullopt;
      const int marker = bytes[at + 1];
      const std::size_t length = big_endian(bytes.subspan(at + kMarker), 2);
      if (length < 2 || at + kMarker + length > bytes.size()) return std::nullopt;
      if (marker == kStartOfScan) return size_ ? std::optional(upright(*size_, orientation_)) : std::nullopt;
      if (!take(marker, bytes.subspan(at + kMarker + 2, length - 2))) return std::nullopt;
      at += kMarker + length;
    }
    return std::nullopt;
  }

 private:
  /// @return  whether it is known what this segment says.
  bool take(int marker, Bytes data) {
    constexpr int kComment = 0xfe, kFirstOfApplication = 0xe0, kExifOrXmp = 0xe1, kLastOfApplication = 0xef;
    constexpr int kTables = 0xdb, kHuffman = 0xc4, kRestart = 0xdd;
    if (marker >= 0xc0 && marker <= 0xc2) return take_frame(data);
    if (marker == kExifOrXmp && text_of(data).starts_with("Exif")) return take_exif(data);
    // XMP and comments may say it in words.
    if (marker == kExifOrXmp || marker == kComment)
      return lower(text_of(data)).find("orientation") == std::string::npos;
    return (marker >= kFirstOfApplication && marker <= kLastOfApplication) || marker == kTables || marker == kHuffman ||
           marker == kRestart;
  }

  /// Baseline, extended or progressive, 8 bits, grey or three colours, a height that is given here.
  bool take_frame(Bytes data) {
    constexpr std::size_t kBeforeComponents = 6, kComponent = 3;
    if (size_ || data.size() < kBeforeComponents || data[0] != 8) return false;
    const std::size_t components = data[5];
    if ((components != 1 && components != 3) || data.size() != kBeforeComponents + components * kComponent)
      return false;
    size_ =
        cv::Size(static_cast<int>(big_endian(data.subspan(3), 2)), static_cast<int>(big_endian(data.subspan(1), 2)));
    return !size_->empty();
  }

  bool take_exif(Bytes data) {
    constexpr std::string_view kExif("Exif\0\0", 6);
    if (!text_of(data).starts_with(kExif)) return false;
    const std::optional<int> says = exif_orientation(data.subspan(kExif.size()));
    if (!says || std::exchange(has_exif_, true)) return false;
    orientation_ = *says;
    return true;
  }

  std::optional<cv::Size> size_;
  bool has_exif_ = false;
  int orientation_ = 1;
};

}  // namespace

std::optional<cv::Size> quick_size(const std::filesystem::path& file) {
  constexpr std::uintmax_t kJpegHeader = std::uintmax_t{1} << 20;
  const std::string format = sniff_format(file);
  if (format != "png" && format != "jpeg") return std::nullopt;
  const bool is_png = format == "png";
  const auto bytes = head_of(file, is_png ? std::numeric_limits<std::uintmax_t>::max() : kJpegHeader);
  if (!bytes) return std::nullopt;
  if (is_png) check_png(file, *bytes);
  const std::optional<cv::Size> size = is_png ? png_size(*bytes) : JpegHeader().size_of(*bytes);
  if (size) check_size(file, size->width, size->height, 1);
  return size;
}

}  // namespace morphkit::media
