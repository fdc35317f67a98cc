#pragma once
// Sampling that looks at the whole area that an output pixel covers in the source. Internal to warp; tests and
// benchmarks may look inside.
//
// Around a pixel the map is taken as affine: J = d(source)/d(output), from differences of the positions of the band. A
// weight is separable in the pixel's own coordinates (u, v) = J^-1 (source pixel's centre - position):
//
//   pixel = sum k(u) k(v) source / sum k(u) k(v).
//
// The singular values of J tell how many source pixels go into an output pixel along the two axes of the footprint.
// They are held in [1, kMostStretch]: a footprint never gets smaller than a source pixel, and its cost is bounded.
// Below kRampBegin a pixel is a point, read by bicubic interpolation; from there to kRampEnd it changes smoothly into
// its footprint.
//
// An area that shrinks by less than kSumBegin is not summed: that costs twenty times as much as a point. Instead points
// of the same weight stand for it, with the variance of the area's square in every direction, less a source pixel's
// own: what they do to a wave is the same to second order, and where a picture shrinks by half they cancel the highest
// frequency. With U diag(d1, d2) U^T the root S of that variance, and J = (U diag(sigma) U^T) R,
//   two points at +- d1 U1 are enough where only one axis shrinks, d2 = 0;
//   four at S R (+-1, +-1)^T serve both axes, and do not ask which is the first where they shrink alike.
// The mean of the two kinds changes over with d2 / d1, from 0 to kFourPoints. From kSumBegin to kSumEnd points change
// smoothly into the sum.

#include "warp/sample/sample.h"

namespace morphkit::warp::detail {

/// The larger singular value of J, source px per output px, where a pixel begins to be more than a point and where it
/// is its whole footprint. A picture that shrinks by a tenth has hardly any detail that could alias; a ramp from 1
/// to 1.25 draws pictures whose pixels are means too softly, by up to a decibel and a half.
inline constexpr float kRampBegin = 1.1F;
inline constexpr float kRampEnd = 1.5F;

/// Singular values where an area begins to be summed, and where it is nothing but a sum. Over the frequencies that a
/// picture can hold, the response of two points is off that of the square by 0.05 (rms) at 2.1 and by 0.07 at 2.5, and
/// above the output's Nyquist frequency no stronger than the sum's; at 3 it would be off by 0.13.
inline constexpr float kSumBegin = 2.1F;
inline constexpr float kSumEnd = 2.5F;

/// d2 / d1 from which an area is four points only.
inline constexpr float kFourPoints = 0.5F;

/// The part of a source pixel's own square that an area's square does without. A photograph's pixels are means over
/// their squares already; a footprint of the variance of J's square minus all of it would be best for them, none for
/// pixels that are points. Half serves both.
inline constexpr float kOwnSquare = 0.5F;

/// Positions are held within this, px, so that squares of squares of their differences stay in the range of a float.
inline constexpr float kFarthestPosition = 0x1p24F;

/// How far antialias_band may be from the reference, for pixels of magnitude 1.
inline constexpr double kAntialiasTolerance = 2e-4;

/// A band of rows, as warp::sample_band, for AntialiasingFilters. The positions of this band alone tell the
/// footprints; a position that is not finite counts for nothing.
/// @pre  sizes are equal, the source is not empty.
/// Class T: within kAntialiasTolerance of the reference on every instruction set.
void antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out) noexcept;

/// The specification, in double: every source pixel that could count is asked.
void reference_antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out);

}  // namespace morphkit::warp::detail
