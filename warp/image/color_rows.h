#pragma once
// Rows of pixels as rows of codes, for files and encoders: the sRGB curve, unpremultiplied alpha, luma and colour
// differences.
//
// Everything here is of class E: the vector kernels give the same bits as the reference on every instruction
// set.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::warp {

/// Nearest sRGB code for linear light, exact: a value lies in code k if it is at or above the linear value of k - 1/2.
class SrgbQuantizer {
 public:
  /// @param largest  the largest code, 255 or 65535.
  explicit SrgbQuantizer(int largest);
  /// NaN and values below 0 give 0; values above 1 give the largest code.
  std::uint16_t operator()(float linear) const noexcept;

  /// The quantizer for a type of code, made at the first call.
  template <typename Code>
  static const SrgbQuantizer& of();

 private:
  int largest_;
  std::vector<float> threshold_;      ///< threshold_[k]: the smallest value of code k + 1
  std::vector<std::uint16_t> first_;  ///< code at the beginning of each bucket of values
};

/// Pixels as interleaved codes. RGB (3 channels) is the picture over black; RGBA is unpremultiplied; transparent pixels
/// get colour 0. Every code is the nearest (SrgbQuantizer; alpha: ties to even); values out of range are clamped; NaN
/// counts as 0.
/// @param channels  3 or 4.
/// @param codes     pixels.size() * channels of them. Code: std::uint8_t or std::uint16_t.
/// Cost: see tests/bench/codec_bench.cpp.
template <typename Code>
void srgb_codes(std::span<const Pixel> pixels, int channels, Code* codes) noexcept;

/// The specification of srgb_codes.
template <typename Code>
void reference_srgb_codes(std::span<const Pixel> pixels, int channels, Code* codes) noexcept;

/// Bound on |display_from_linear - exact sRGB|, on the scale where white is 1: a 65th of a 16-bit code.
inline constexpr float kDisplayTolerance = 0x1p-22F;

/// Linear light -> display-referred sRGB, both clamped to [0, 1]; NaN becomes 0. Unlike srgb_from_linear it uses only
/// float additions, multiplications and square roots, so that vector code gives the same bits.
/// Accuracy: kDisplayTolerance.
float display_from_linear(float linear) noexcept;

/// A row in display-referred light: a plane for each channel, every value in [0, 1].
class DisplayRow {
 public:
  explicit DisplayRow(std::size_t width);
  std::size_t width() const noexcept { return width_; }
  /// Plane 0..3 (red, green, blue, alpha). One value before the first and one after the last repeat them.
  float* plane(int channel) noexcept { return values_.data() + offset(channel); }
  const float* plane(int channel) const noexcept { return values_.data() + offset(channel); }

  /// Vectors may read and write this many values before and after a plane.
  static constexpr std::size_t kMargin = 64;

 private:
  std::size_t offset(int channel) const noexcept { return kMargin + static_cast<std::size_t>(channel) * stride_; }

  std::size_t width_, stride_;
  std::vector<float> values_;
};

/// Pixels into display-referred light: over black, or unpremultiplied where alpha is not 0 (`straight`). The row may be
/// wider than the pixels, of which there is at least one; it then repeats the last pixel.
void to_display(std::span<const Pixel> pixels, bool straight, DisplayRow& row) noexcept;
void reference_to_display(std::span<const Pixel> pixels, bool straight, DisplayRow& row) noexcept;

/// The colours of every `across`-th column (1 or 2) of the mean of two rows, which may be the same. With `across` = 2 a
/// column and its neighbours weigh 1/4, 1/2, 1/4, so the result lies on the even columns.
/// @param out  as wide as the rows, or half of it, rounded up; its alpha is not touched.
void mean_row(const DisplayRow& upper, const DisplayRow& lower, int across, DisplayRow& out) noexcept;
void reference_mean_row(const DisplayRow& upper, const DisplayRow& lower, int across, DisplayRow& out) noexcept;

/// offset + the weighted sum of the four planes, in codes.
struct CodeWeights {
  float offset;
  float weight[4];
};

/// The nearest code (ties to even) of a weighted sum of the planes. The sum must be in the range of Code.
template <typename Code>
void weighted_codes(const DisplayRow& row, const CodeWeights& weights, Code* codes) noexcept;
template <typename Code>
void reference_weighted_codes(const DisplayRow& row, const CodeWeights& weights, Code* codes) noexcept;

namespace detail {

// The power piece of the sRGB curve, 1.055 x^(5/12) - 0.055, as a polynomial in the fourth root of x, around
// kCurveMiddle: the root takes [0.0031, 1] to [0.24, 1], where a polynomial converges fast (interpolated at Chebyshev
// nodes; error below 2.6e-8 without rounding).
inline constexpr float kCurveBreak = 0.00313066844F;  ///< linear value where the straight piece ends
inline constexpr float kCurveSlope = 12.92F;
inline constexpr float kCurveMiddle = 0.618271291F;
inline constexpr float kCurve[] = {0.418388399F,   1.27610738F,   0.687991841F,   -0.12362481F, 0.0669635325F,
                                   -0.0509378519F, 0.0397614037F, -0.0362037357F, 0.086169734F, -0.109079987F};

}  // namespace detail
}  // namespace morphkit::warp
