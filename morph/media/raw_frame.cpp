#include "morph/media/raw_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "warp/color.h"

namespace morphkit::media {
namespace {

static_assert(std::endian::native == std::endian::little, "the 10- and 16-bit layouts are little-endian");

struct Layout {
  const char* pix_fmt;
  int bits;
  bool alpha;
  bool yuv;
  int across, down;  ///< luma samples per chroma sample
};

const Layout& layout_of(RawFormat format) {
  static constexpr std::array<Layout, 8> kLayouts = {{{"rgb24", 8, false, false, 1, 1},
                                                      {"rgba", 8, true, false, 1, 1},
                                                      {"rgb48le", 16, false, false, 1, 1},
                                                      {"rgba64le", 16, true, false, 1, 1},
                                                      {"yuv420p", 8, false, true, 2, 2},
                                                      {"yuva420p", 8, true, true, 2, 2},
                                                      {"yuv422p10le", 10, false, true, 2, 1},
                                                      {"yuva444p10le", 10, true, true, 1, 1}}};
  return kLayouts[static_cast<std::size_t>(format)];
}

/// One row, display-referred, every value in [0, 1].
struct Row {
  explicit Row(int width) : r(width), g(width), b(width), a(width) {}
  std::vector<float> r, g, b, a;
};

/// Into [0, 1]; NaN becomes 0.
float unit(float value) {
  return value > 0.0F ? std::min(value, 1.0F) : 0.0F;
}

void read_row(const warp::Image& image, int y, bool straight_alpha, Row& row) {
  const warp::Pixel* pixels = image[std::min(y, image.rows - 1)];
  const int width = static_cast<int>(row.r.size());
  for (int x = 0; x < width; ++x) {
    const warp::Pixel& pixel = pixels[std::min(x, image.cols - 1)];
    row.a[x] = unit(pixel[3]);
    // Premultiplied colour is the picture over black; straight alpha needs the division, in linear light.
    const float divisor = straight_alpha && pixel[3] > 0.0F ? pixel[3] : 1.0F;
    row.r[x] = unit(pixel[0] / divisor);
    row.g[x] = unit(pixel[1] / divisor);
    row.b[x] = unit(pixel[2] / divisor);
  }
  for (auto* plane : {&row.r, &row.g, &row.b}) warp::srgb_from_linear(*plane);
}

/// Writes codes of one width one after the other.
template <typename Code>
class Codes {
 public:
  explicit Codes(std::vector<std::uint8_t>& bytes, std::size_t first_code = 0)
      : next_(reinterpret_cast<Code*>(bytes.data()) + first_code) {}
  /// `value` is in codes, already within their range.
  void put(float value) { *next_++ = static_cast<Code>(std::lround(value)); }

 private:
  Code* next_;
};

template <typename Code>
void put_rgb(const warp::Image& image, const Layout& layout, cv::Size size, std::vector<std::uint8_t>& bytes) {
  const auto top = static_cast<float>((1 << layout.bits) - 1);
  Codes<Code> codes(bytes);
  Row row(size.width);
  for (int y = 0; y < size.height; ++y) {
    read_row(image, y, layout.alpha, row);
    for (int x = 0; x < size.width; ++x) {
      codes.put(row.r[x] * top);
      codes.put(row.g[x] * top);
      codes.put(row.b[x] * top);
      if (layout.alpha) codes.put(row.a[x] * top);
    }
  }
}

// Rec. ITU-R BT.709-6, items 3.2 and 3.3: the weights of luma and the scales of the colour differences; item 4.6 (and
// Rec. ITU-R H.273, equations 8-10): their codes in limited range, for 8 bits; a wider code is a multiple.
constexpr float kWeightR = 0.2126F, kWeightG = 0.7152F, kWeightB = 0.0722F;
constexpr float kScaleCb = 1.8556F, kScaleCr = 1.5748F;

float luma(float r, float g, float b) {
  return kWeightR * r + kWeightG * g + kWeightB * b;
}

/// The planes of one Y'CbCr frame, filled from the top.
template <typename Code>
class YuvPlanes {
 public:
  YuvPlanes(const Layout& layout, cv::Size size, std::vector<std::uint8_t>& bytes)
      : layout_(layout),
        scale_(static_cast<float>(1 << (layout.bits - 8))),
        y_(bytes),
        cb_(bytes, luma_codes(size)),
        cr_(bytes, luma_codes(size) + chroma_codes(layout, size)),
        alpha_(bytes, luma_codes(size) + 2 * chroma_codes(layout, size)) {}

  static std::size_t luma_codes(cv::Size size) { return static_cast<std::size_t>(size.width) * size.height; }
  static std::size_t chroma_codes(const Layout& layout, cv::Size size) {
    return luma_codes(
        {(size.width + layout.across - 1) / layout.across, (size.height + layout.down - 1) / layout.down});
  }

  void put_luma_and_alpha(const Row& row) {
    const auto top = static_cast<float>((1 << layout_.bits) - 1);
    for (std::size_t x = 0; x < row.r.size(); ++x) {
      y_.put((16.0F + 219.0F * luma(row.r[x], row.g[x], row.b[x])) * scale_);
      if (layout_.alpha) alpha_.put(row.a[x] * top);
    }
  }

  /// Chroma of a row of the subsampled height: the mean of `upper` and `lower` (the same row where it is not halved).
  void put_chroma(const Row& upper, const Row& lower) {
    const std::size_t width = upper.r.size();
    const auto mean = [&](const std::vector<float> Row::*plane, std::size_t x) {
      return 0.5F * ((upper.*plane)[x] + (lower.*plane)[x]);
    };
    // Halved chroma lies on the even luma columns (chroma_sample_location left, what H.264 and VP9 players assume), so
    // the filter is the symmetric 1/4 1/2 1/4 around them.
    const auto across = [&](const std::vector<float> Row::*plane, std::size_t x) {
      if (layout_.across == 1) return mean(plane, x);
      const std::size_t left = x == 0 ? 0 : x - 1;
      const std::size_t right = std::min(x + 1, width - 1);
      return 0.25F * (mean(plane, left) + mean(plane, right)) + 0.5F * mean(plane, x);
    };
    for (std::size_t x = 0; x < width; x += layout_.across) {
      const float r = across(&Row::r, x);
      const float g = across(&Row::g, x);
      const float b = across(&Row::b, x);
      const float y = luma(r, g, b);
      cb_.put((128.0F + 224.0F * (b - y) / kScaleCb) * scale_);
      cr_.put((128.0F + 224.0F * (r - y) / kScaleCr) * scale_);
    }
  }

 private:
  const Layout& layout_;
  float scale_;  ///< codes per 8-bit code
  Codes<Code> y_, cb_, cr_, alpha_;
};

template <typename Code>
void put_yuv(const warp::Image& image, const Layout& layout, cv::Size size, std::vector<std::uint8_t>& bytes) {
  YuvPlanes<Code> planes(layout, size, bytes);
  Row upper(size.width);
  Row lower(size.width);
  for (int y = 0; y < size.height; y += layout.down) {
    read_row(image, y, layout.alpha, upper);
    planes.put_luma_and_alpha(upper);
    if (layout.down == 1 || y + 1 == size.height) {
      planes.put_chroma(upper, upper);
    } else {
      read_row(image, y + 1, layout.alpha, lower);
      planes.put_luma_and_alpha(lower);
      planes.put_chroma(upper, lower);
    }
  }
}

std::size_t bytes_of(const Layout& layout, cv::Size size) {
  const std::size_t luma_codes = YuvPlanes<std::uint8_t>::luma_codes(size);
  const std::size_t colour =
      layout.yuv ? luma_codes + 2 * YuvPlanes<std::uint8_t>::chroma_codes(layout, size) : 3 * luma_codes;
  return (colour + (layout.alpha ? luma_codes : 0)) * (layout.bits > 8 ? 2 : 1);
}

}  // namespace

const char* pix_fmt(RawFormat format) {
  return layout_of(format).pix_fmt;
}

std::vector<std::uint8_t> raw_frame(const warp::Image& image, RawFormat format, cv::Size size) {
  if (image.empty() || image.cols > size.width || image.rows > size.height)
    throw std::invalid_argument(fmt::format("an image of {}x{} px does not fit a frame of {}x{} px", image.cols,
                                            image.rows, size.width, size.height));
  const Layout& layout = layout_of(format);
  std::vector<std::uint8_t> bytes(bytes_of(layout, size));
  if (layout.yuv) {
    (layout.bits > 8 ? put_yuv<std::uint16_t> : put_yuv<std::uint8_t>)(image, layout, size, bytes);
  } else {
    (layout.bits > 8 ? put_rgb<std::uint16_t> : put_rgb<std::uint8_t>)(image, layout, size, bytes);
  }
  return bytes;
}

}  // namespace morphkit::media
