#include "morph/media/image_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "base/words.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;

const std::vector<WritableFormat>& writable_formats() {
  static const std::vector<WritableFormat> formats = {
      {"png", "PNG", {".png"}, {Depth::k8, Depth::k16}, true, 65535, true, true},
      {"tiff", "TIFF", {".tif", ".tiff"}, {Depth::k16, Depth::k8, Depth::kFloat}, true, 65535, true, true},
      {"jpeg", "JPEG", {".jpg", ".jpeg", ".jpe"}, {Depth::k8}, false, 65500, false, true},
      {"webp", "WebP", {".webp"}, {Depth::k8}, true, 16383, false, false},
      {"targa", "TGA", {".tga"}, {Depth::k8}, true, 65535, false, false},
      {"openexr", "EXR", {".exr"}, {Depth::kHalf, Depth::kFloat}, true, 65535, true, true},
  };
  return formats;
}

struct Magic {
  std::size_t offset;
  std::string_view bytes;
  const char* format;
};

using namespace std::string_view_literals;

constexpr std::array kMagics = {
    Magic{0, "\x89PNG\r\n\x1a\n"sv, "png"},
    Magic{0, "\xff\xd8\xff"sv, "jpeg"},
    Magic{0, "II*\0"sv, "tiff"},
    Magic{0, "MM\0*"sv, "tiff"},
    Magic{0, "II+\0"sv, "tiff"},  // BigTIFF
    Magic{0, "MM\0+"sv, "tiff"},
    Magic{0, "\x76\x2f\x31\x01"sv, "openexr"},
    Magic{8, "WEBP"sv, "webp"},
    Magic{0, "BM"sv, "bmp"},
    Magic{0, "GIF87a"sv, "gif"},
    Magic{0, "GIF89a"sv, "gif"},
    Magic{0, "#?RADIANCE"sv, "hdr"},
    Magic{0, "#?RGBE"sv, "hdr"},
    Magic{0, "8BPS"sv, "psd"},
    Magic{0, "SDPX"sv, "dpx"},
    Magic{0, "XPDS"sv, "dpx"},
    Magic{4, "ftypheic"sv, "heif"},
    Magic{4, "ftypheix"sv, "heif"},
    Magic{4, "ftypmif1"sv, "heif"},
    Magic{4, "ftypavif"sv, "heif"},
};

constexpr const char* kSupported = "supported are PNG, TIFF, JPEG, WebP, TGA, EXR, BMP, GIF, PNM, HDR, PSD, DPX, HEIC";

bool is_pnm(std::string_view head) {
  return head.size() > 2 && head[0] == 'P' && std::string_view("123456Ff").find(head[1]) != std::string_view::npos &&
         std::isspace(static_cast<unsigned char>(head[2])) != 0;
}

std::string read_head(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const std::string place = file.string();
  if (status.type() == fs::file_type::not_found) throw Error(ErrorKind::kIo, place, "does not exist");
  if (fs::is_directory(status)) throw Error(ErrorKind::kIo, place, "is a folder, not an image");
  if (fs::exists(status) && !fs::is_regular_file(status)) throw Error(ErrorKind::kIo, place, "is not a regular file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 32> head{};
  if (stream) stream.read(head.data(), head.size());
  if (!stream.is_open() || stream.bad()) {
    throw Error(ErrorKind::kIo, place, "cannot be read: " + std::generic_category().message(errno != 0 ? errno : EIO));
  }
  if (stream.gcount() == 0) throw Error(ErrorKind::kBadInput, place, "is empty");
  return std::string(head.data(), static_cast<std::size_t>(stream.gcount()));
}

ImageLimits& mutable_limits() {
  static ImageLimits limits;
  return limits;
}

}  // namespace

const WritableFormat* writable_format(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  for (const WritableFormat& format : writable_formats()) {
    if (std::find(format.names.begin(), format.names.end(), extension) != format.names.end()) return &format;
  }
  return nullptr;
}

std::string writable_extensions() {
  std::vector<std::string> names;
  for (const WritableFormat& format : writable_formats()) {
    names.insert(names.end(), format.names.begin(), format.names.end());
  }
  return fmt::format("{}", fmt::join(names, " "));
}

std::string sniff_format(const fs::path& file) {
  const std::string head = read_head(file);
  for (const Magic& magic : kMagics) {
    if (head.size() >= magic.offset && head.compare(magic.offset, magic.bytes.size(), magic.bytes) == 0) {
      return magic.format;
    }
  }
  if (is_pnm(head)) return "pnm";
  if (lower(file.extension().string()) == ".tga") return "targa";
  throw Error(
      ErrorKind::kUnsupported, file.string(),
      fmt::format("not an image that morphkit can read (its first bytes are of no known format); {}", kSupported));
}

std::string shown_depth(Depth depth) {
  switch (depth) {
    case Depth::kAuto:
      return "auto";
    case Depth::k8:
      return "8 bit";
    case Depth::k16:
      return "16 bit";
    case Depth::kHalf:
      return "half";
    case Depth::kFloat:
      return "float";
  }
  return "unknown";
}

const ImageLimits& image_limits() {
  return mutable_limits();
}

void set_image_limits(const ImageLimits& limits) {
  mutable_limits() = limits;
}

void check_size(const fs::path& file, std::int64_t width, std::int64_t height, std::int64_t channels) {
  const ImageLimits& limits = image_limits();
  if (width < 1 || height < 1 || channels < 1) {
    throw Error(ErrorKind::kBadInput, file.string(),
                fmt::format("has no pixels ({} x {}, {} channels)", width, height, channels));
  }
  if (width > limits.side || height > limits.side || width * height > limits.pixels) {
    throw Error(ErrorKind::kBadInput, file.string(),
                fmt::format("says that it has {} x {} pixels; at most {} on a side and {} in all can be read", width,
                            height, limits.side, limits.pixels));
  }
  if (channels > limits.channels) {
    throw Error(ErrorKind::kBadInput, file.string(),
                fmt::format("says that it has {} channels; at most {} can be read", channels, limits.channels));
  }
}

}  // namespace morphkit::media
