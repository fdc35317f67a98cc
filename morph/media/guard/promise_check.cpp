#include "morph/media/guard/promise_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "base/error.h"
#include "morph/media/image_format.h"

namespace morphkit::media {
namespace {

enum class Order { kLittle, kBig };

/// Reads numbers from places in a file.
class Promises {
 public:
  Promises(const std::filesystem::path& file, std::string shown, Order order)
      : file_(file),
        stream_(file, std::ios::binary),
        shown_(std::move(shown)),
        order_(order),
        size_(static_cast<std::int64_t>(std::filesystem::file_size(file))) {}

  void go_to(std::int64_t position) { position_ = position; }
  std::int64_t position() const { return position_; }

  /// Reads an unsigned number of 1 to 4 bytes at the position and moves past it.
  std::int64_t number(int bytes) {
    if (position_ > size_ - bytes) {
      fail(fmt::format("the {} file is cut short: it ends at byte {}, within its header", shown_, size_));
    }
    stream_.seekg(position_);
    position_ += bytes;
    std::int64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const std::int64_t byte = stream_.get() & 0xff;
      value = order_ == Order::kBig ? value << 8 | byte : value | byte << (8 * i);
    }
    return value;
  }

  std::int64_t signed_number() { return std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(number(4))); }

  /// @return  the byte after `length` bytes that begin at the position.
  std::int64_t end_of(const std::string& what, std::int64_t length) const {
    if (length < 0 || length > size_ - position_) {
      fail(fmt::format("the {} file is damaged or cut short: {} at byte {} needs {} bytes, {} are left", shown_, what,
                       position_, length, size_ - position_));
    }
    return position_ + length;
  }

  void check_size(std::int64_t width, std::int64_t height) const { media::check_size(file_, width, height, 1); }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::kBadInput, file_.string(), message);
  }

  std::filesystem::path file_;
  std::ifstream stream_;
  std::string shown_;
  Order order_;
  std::int64_t size_;
  std::int64_t position_ = 0;
};

/// GIF89a specification, 18: the logical screen.
void check_gif(const std::filesystem::path& file) {
  Promises gif(file, "GIF", Order::kLittle);
  gif.go_to(6);
  const std::int64_t width = gif.number(2);
  gif.check_size(width, gif.number(2));
}

/// BITMAPCOREHEADER has 12 bytes and 16-bit sizes, its followers have 32-bit ones; a negative height means top down.
void check_bmp(const std::filesystem::path& file) {
  constexpr std::int64_t kCoreHeader = 12;
  Promises bmp(file, "BMP", Order::kLittle);
  bmp.go_to(14);
  const bool is_core = bmp.number(4) == kCoreHeader;
  const std::int64_t width = is_core ? bmp.number(2) : bmp.signed_number();
  const std::int64_t height = is_core ? bmp.number(2) : bmp.signed_number();
  bmp.check_size(width, std::abs(height));
}

/// SMPTE ST 268: generic header, then image header; the magic number gives the byte order.
void check_dpx(const std::filesystem::path& file) {
  constexpr std::int64_t kNoSize = 0xffffffff;
  constexpr std::int64_t kHeaders = 2048;
  Promises dpx(file, "DPX", Promises(file, "DPX", Order::kBig).number(1) == 'S' ? Order::kBig : Order::kLittle);
  dpx.go_to(32);
  const std::int64_t user_data = dpx.number(4);
  dpx.go_to(772);
  const std::int64_t width = dpx.number(4);
  dpx.check_size(width, dpx.number(4));
  dpx.go_to(kHeaders);
  if (user_data != kNoSize) dpx.end_of("the user data", user_data);
}

/// Adobe Photoshop File Formats Specification: header, colour mode data, image resources, layers, merged picture.
class PsdPromises {
 public:
  explicit PsdPromises(const std::filesystem::path& file) : psd_(file, "PSD", Order::kBig) {}

  void check() {
    psd_.go_to(4);
    is_large_ = psd_.number(2) == 2;  // PSB: some lengths have 8 bytes
    psd_.go_to(14);
    const std::int64_t height = psd_.number(4);
    psd_.check_size(psd_.number(4), height);
    psd_.go_to(26);
    const std::int64_t colors = psd_.number(4);
    psd_.go_to(psd_.end_of("the colour mode data", colors));
    check_resources();
    check_layers();
  }

 private:
  void check_resources() {
    constexpr int kSignatureAndId = 6;
    const std::int64_t length = psd_.number(4);
    const std::int64_t end = psd_.end_of("the section of resources", length);
    while (psd_.position() < end) {
      psd_.go_to(psd_.position() + kSignatureAndId);
      const std::int64_t name = psd_.number(1);
      psd_.go_to(psd_.position() + (name | 1));  // padded: the length byte and the name are even together
      const std::int64_t data = psd_.number(4);
      psd_.go_to(psd_.end_of("an image resource", data) + data % 2);
    }
    psd_.go_to(end);
  }

  std::int64_t length() {
    if (!is_large_) return psd_.number(4);
    const std::int64_t high = psd_.signed_number();
    return (high << 32) | psd_.number(4);
  }

  void check_layers() {
    const std::int64_t section = length();
    psd_.end_of("the section of layers", section);
    if (section == 0) return;
    const std::int64_t layers = length();
    psd_.end_of("the list of layers", layers);
    if (layers == 0) return;
    const auto count = std::abs(static_cast<int>(static_cast<std::int16_t>(psd_.number(2))));
    for (int i = 0; i < count; ++i) check_layer();
  }

  void check_layer() {
    constexpr int kBlending = 12;  // signature, mode, opacity, clipping, flags, filler
    const std::int64_t top = psd_.signed_number();
    const std::int64_t left = psd_.signed_number();
    const std::int64_t bottom = psd_.signed_number();
    const std::int64_t right = psd_.signed_number();
    // Groups are layers without pixels.
    psd_.check_size(std::max<std::int64_t>(1, std::abs(right - left)),
                    std::max<std::int64_t>(1, std::abs(bottom - top)));
    const std::int64_t channels = psd_.number(2);
    psd_.go_to(psd_.position() + channels * (is_large_ ? 10 : 6) + kBlending);
    const std::int64_t extra = psd_.number(4);
    psd_.go_to(psd_.end_of("a layer's extra data", extra));
  }

  Promises psd_;
  bool is_large_ = false;
};

}  // namespace

void check_promises(const std::filesystem::path& file, const std::string& format) {
  if (format == "gif") check_gif(file);
  if (format == "bmp") check_bmp(file);
  if (format == "dpx") check_dpx(file);
  if (format == "psd") PsdPromises(file).check();
}

}  // namespace morphkit::media
