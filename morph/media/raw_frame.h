#pragma once
// Frames as uncompressed pixels for the standard input of ffmpeg. Internal to morph/media.

#include <cstdint>
#include <string>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::media {

/// Uncompressed pixel layouts. RGB and alpha are full range, Y'CbCr is BT.709 limited range. Unpremultiplied.
enum class RawFormat {
  kRgb24,      ///< 8 bit
  kRgba,       ///< 8 bit, unpremultiplied
  kRgb48,      ///< 16 bit
  kRgba64,     ///< 16 bit, unpremultiplied
  kYuv420p,    ///< 8 bit, chroma halved both ways
  kYuva420p,   ///< the same with alpha
  kYuv422p10,  ///< 10 bit, chroma halved across
  kYuva444p10  ///< 10 bit with alpha
};

/// ffmpeg's name for it (-pix_fmt).
const char* pix_fmt(RawFormat format);

/// The image as one raw frame of `size`, which is at least the size of the image: missing columns at the right and rows
/// at the bottom repeat the last ones. Formats without alpha get the image over black. RGB codes are the nearest ones,
/// Y'CbCr codes are nearest within kDisplayTolerance (warp/image/color_rows.h). Values out of range are clamped; NaN
/// counts as 0. Cost: O(pixels), parallel over rows; see tests/bench/codec_bench.cpp.
std::vector<std::uint8_t> raw_frame(const warp::Image& image, RawFormat format, cv::Size size);

}  // namespace morphkit::media
