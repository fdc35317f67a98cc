#pragma once
// Frames as the uncompressed pixels that ffmpeg takes on its standard input. Internal to morph/media.

#include <cstdint>
#include <string>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::media {

/// Uncompressed pixel layouts. RGB is full range, Y'CbCr is BT.709 limited range; alpha is straight and full range.
enum class RawFormat {
  kRgb24,      ///< 8 bit
  kRgba,       ///< 8 bit, straight alpha
  kRgb48,      ///< 16 bit
  kRgba64,     ///< 16 bit, straight alpha
  kYuv420p,    ///< 8 bit, chroma halved both ways
  kYuva420p,   ///< the same with straight alpha
  kYuv422p10,  ///< 10 bit, chroma halved across
  kYuva444p10  ///< 10 bit with straight alpha
};

/// ffmpeg's name for it (-pix_fmt).
const char* pix_fmt(RawFormat format);

/// The image as one raw frame of `size`, which is at least the image's: what is missing at the right and at the bottom
/// repeats the last column and row. Formats without alpha get the image over black. RGB codes are the nearest ones,
/// Y'CbCr codes the nearest to what kDisplayTolerance leaves (warp/color_rows.h); what does not fit is clamped; NaN
/// counts as 0. Cost: O(pixels), parallel over rows; see tests/bench/codec_bench.cpp.
std::vector<std::uint8_t> raw_frame(const warp::Image& image, RawFormat format, cv::Size size);

}  // namespace morphkit::media
