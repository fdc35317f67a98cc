#pragma once
// The sRGB transfer function (IEC 61966-2-1), extended to all real numbers by odd symmetry: values below 0 and above 1
// survive a round trip.

#include <span>

#include "warp/image/image.h"

namespace morphkit::warp {

/// Display-referred sRGB value -> linear light. Follows the power curve and the straight piece of the standard. They
/// switch at their true intersection (linear 0.0031306684, not the rounded 0.0031308): both directions are then
/// continuous and monotone, and differ from the standard by 3e-8 at most. NaN and infinities stay.
/// Accuracy: within 1 ulp of the exact value. Cost: about 2 ns.
float linear_from_srgb(float value) noexcept;

/// Linear light -> display-referred sRGB value; the inverse of linear_from_srgb, with the same properties.
float srgb_from_linear(float value) noexcept;

/// The same for many values, in place.
void linear_from_srgb(std::span<float> values) noexcept;
void srgb_from_linear(std::span<float> values) noexcept;

}  // namespace morphkit::warp
