#include "morph/media/raw_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "base/parallel.h"
#include "warp/image/color_rows.h"

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

// Rows of codes that are made together: a whole number of chroma rows.
constexpr int kBandRows = 16;

/// Calls fn(begin, end) for bands of a frame's rows, in parallel.
template <typename Fn>
void for_bands(cv::Size size, const Fn& fn) {
  for_rows(size.height, fn, kBandRows);
}

/// The row of the image for a row of the frame: rows below the image repeat its last row.
std::span<const warp::Pixel> row_of(const warp::Image& image, int y) {
  return {image[std::min(y, image.rows - 1)], static_cast<std::size_t>(image.cols)};
}

template <typename Code>
void put_rgb(const warp::Image& image, const Layout& layout, cv::Size size, std::vector<std::uint8_t>& bytes) {
  const std::size_t channels = layout.alpha ? 4 : 3;
  const std::size_t width = channels * static_cast<std::size_t>(size.width);
  Code* const codes = reinterpret_cast<Code*>(bytes.data());
  for_bands(size, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      Code* const row = codes + width * static_cast<std::size_t>(y);
      const std::span<const warp::Pixel> pixels = row_of(image, y);
      warp::srgb_codes(pixels, static_cast<int>(channels), row);
      for (std::size_t i = channels * pixels.size(); i < width; ++i) row[i] = row[i - channels];
    }
  });
}

// Rec. ITU-R BT.709-6, items 3.2 and 3.3: the weights of luma and the scales of the colour differences; item 4.6 (and
// Rec. ITU-R H.273, equations 8-10): their codes in limited range, for 8 bits; a wider code is a multiple.
constexpr float kWeightR = 0.2126F, kWeightG = 0.7152F, kWeightB = 0.0722F;
constexpr float kScaleCb = 1.8556F, kScaleCr = 1.5748F;

/// Weights that make the planes of a frame from display-referred colour.
struct YuvWeights {
  warp::CodeWeights y, cb, cr, alpha;

  explicit YuvWeights(const Layout& layout) {
    const auto scale = static_cast<float>(1 << (layout.bits - 8));
    const float luma = 219.0F * scale;
    const float blue = 224.0F * scale / kScaleCb;
    const float red = 224.0F * scale / kScaleCr;
    y = {16.0F * scale, {kWeightR * luma, kWeightG * luma, kWeightB * luma, 0}};
    cb = {128.0F * scale, {-kWeightR * blue, -kWeightG * blue, (1 - kWeightB) * blue, 0}};
    cr = {128.0F * scale, {(1 - kWeightR) * red, -kWeightG * red, -kWeightB * red, 0}};
    alpha = {0, {0, 0, 0, static_cast<float>((1 << layout.bits) - 1)}};
  }
};

/// The places of the planes of a Y'CbCr frame: luma, both colour differences, alpha.
template <typename Code>
struct YuvPlanes {
  YuvPlanes(const Layout& layout, cv::Size size, std::uint8_t* bytes)
      : width(static_cast<std::size_t>(size.width)),
        chroma_width((width + layout.across - 1) / layout.across),
        y(reinterpret_cast<Code*>(bytes)),
        cb(y + luma_codes(size)),
        cr(cb + chroma_codes(layout, size)),
        alpha(cr + chroma_codes(layout, size)) {}

  static std::size_t luma_codes(cv::Size size) { return static_cast<std::size_t>(size.width) * size.height; }
  static std::size_t chroma_codes(const Layout& layout, cv::Size size) {
    return luma_codes(
        {(size.width + layout.across - 1) / layout.across, (size.height + layout.down - 1) / layout.down});
  }

  std::size_t width, chroma_width;
  Code *y, *cb, *cr, *alpha;
};

template <typename Code>
void put_yuv(const warp::Image& image, const Layout& layout, cv::Size size, std::vector<std::uint8_t>& bytes) {
  const YuvPlanes<Code> planes(layout, size, bytes.data());
  const YuvWeights weights(layout);
  static_assert(kBandRows % 2 == 0, "a band ends with a row of halved chroma");
  for_bands(size, [&](int begin, int end) {
    warp::DisplayRow upper(planes.width);
    warp::DisplayRow lower(planes.width);
    warp::DisplayRow mean(planes.chroma_width);
    const auto put_luma = [&](int y, warp::DisplayRow& row) {
      const std::size_t first = planes.width * static_cast<std::size_t>(y);
      warp::to_display(row_of(image, y), layout.alpha, row);
      warp::weighted_codes(row, weights.y, planes.y + first);
      if (layout.alpha) warp::weighted_codes(row, weights.alpha, planes.alpha + first);
    };
    for (int y = begin; y < end; y += layout.down) {
      const bool halved = layout.down == 2 && y + 1 < end;
      put_luma(y, upper);
      if (halved) put_luma(y + 1, lower);
      // Halved chroma lies on the even luma columns (chroma_sample_location left, as H.264 and VP9 players assume).
      warp::mean_row(upper, halved ? lower : upper, layout.across, mean);
      const std::size_t first = planes.chroma_width * static_cast<std::size_t>(y / layout.down);
      warp::weighted_codes(mean, weights.cb, planes.cb + first);
      warp::weighted_codes(mean, weights.cr, planes.cr + first);
    }
  });
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
