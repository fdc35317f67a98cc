#pragma once
// Mixes two rows of pixels by weight.

#include <span>

#include "warp/image/image.h"

namespace morphkit::warp {

/// C = (1 - alpha) A + alpha B, written to A. Where alpha <= 0 the result is A, and where alpha >= 1 it is B, bit for
/// bit, even if the other holds NaN.
/// @param alpha  one value per pixel, or a single value for all pixels.
/// @pre a and b have the same length and do not overlap.
/// Accuracy: equal to reference_mix_row on every instruction set, but for the sign and payload of NaNs.
void mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept;

/// The same in plain arithmetic: the specification.
void reference_mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept;

}  // namespace morphkit::warp
