#pragma once
// Sampling over the whole area that an output pixel covers in the source. Internal to warp; tests and benchmarks may
// include it.
//
// Around a pixel the map counts as affine: J = d(source)/d(output), from differences of the positions in the band. A
// weight is separable in the pixel's own coordinates (u, v) = J^-1 (source pixel's centre - position):
//
//   pixel = sum k(u) k(v) source / sum k(u) k(v).
//
// The singular values of J are the source pixels per output pixel along the two axes of the footprint. They are clamped
// to [1, kMostStretch]: a footprint is never smaller than a source pixel, and its cost is bounded.
// Below kRampBegin a pixel is a point, read by bicubic interpolation; from kRampBegin to kRampEnd it changes smoothly
// into its footprint.
//
// An area that shrinks by less than kSumBegin is not summed: a sum costs twenty times as much as a point. Points of
// equal weight replace it. In every direction they have the variance of the area's square, less that of a source pixel.
// Their effect on a wave is the same to second order, and where a picture shrinks by half they cancel the highest
// frequency. With U diag(d1, d2) U^T the root S of that variance, and J = (U diag(sigma) U^T) R,
//   two points at +- d1 U1 are enough where only one axis shrinks (d2 = 0);
//   four at S R (+-1, +-1)^T serve both axes, and need no first axis where both shrink alike.
// As d2 / d1 goes from 0 to kFourPoints, the two points change smoothly into the four. From kSumBegin to kSumEnd points
// change smoothly into the sum.

#include "warp/sample/sample.h"

namespace morphkit::warp::detail {

/// The larger singular value of J, source px per output px, where the ramp from point to footprint begins and ends. A
/// picture that shrinks by a tenth has hardly any detail that could alias. A ramp from 1 to 1.25 blurs pictures whose
/// pixels are means, by up to 1.5 dB.
inline constexpr float kRampBegin = 1.1F;
inline constexpr float kRampEnd = 1.5F;

/// Singular values where the ramp from points to the sum begins and ends. Over the frequencies that a picture can hold,
/// the response of two points differs from the square's by 0.05 (rms) at 2.1 and by 0.07 at 2.5, and above the output's
/// Nyquist frequency it is no stronger than the sum's. At 3 it would differ by 0.13.
inline constexpr float kSumBegin = 2.1F;
inline constexpr float kSumEnd = 2.5F;

/// From this d2 / d1 on, an area is four points only.
inline constexpr float kFourPoints = 0.5F;

/// The part of a source pixel's square that is subtracted from an area's square. The pixels of a photograph are already
/// means over their squares: subtracting all of it would be best for them. For pixels that are points, subtracting
/// nothing would be best. Half serves both.
inline constexpr float kOwnSquare = 0.5F;

/// Positions are clamped to this magnitude, px, so fourth powers of their differences stay in the range of a float.
inline constexpr float kFarthestPosition = 0x1p24F;

/// Bound on the error of antialias_band against the reference, for pixels of magnitude 1.
inline constexpr double kAntialiasTolerance = 2e-4;

/// A band of rows, as warp::sample_band, for AntialiasingFilters. Footprints depend on the positions of this band
/// alone; positions that are not finite are ignored.
/// @pre  sizes are equal, the source is not empty.
/// Class T: within kAntialiasTolerance of the reference on every instruction set.
void antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out) noexcept;

/// The specification, in double: it visits every source pixel that could count.
void reference_antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out);

}  // namespace morphkit::warp::detail
