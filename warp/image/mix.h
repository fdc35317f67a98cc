#pragma once
// Two rows of pixels into one, by weight.

#include <span>

#include "warp/image/image.h"

namespace morphkit::warp {

/// C = (1 - alpha) A + alpha B, in place of A. Where alpha is 0 or below the result is A, where it is 1 or above it is
/// B, bit for bit, whatever the other holds.
/// @param alpha  of the rows' length, or of length 1 for all pixels.
/// @pre a and b have one length and do not overlap.
/// Accuracy: equal to reference_mix_row on every instruction set, but for the sign and payload of NaNs.
void mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept;

/// The same in plain arithmetic: the specification.
void reference_mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept;

}  // namespace morphkit::warp
