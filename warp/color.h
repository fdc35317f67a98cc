#pragma once
// The sRGB transfer function (IEC 61966-2-1), extended to all of R by odd symmetry so that values below 0 and above 1
// survive a round trip.

#include "warp/image.h"

namespace morphkit::warp {

/// Display-referred sRGB value -> linear light.
float linear_from_srgb(float value) noexcept;

/// Linear light -> display-referred sRGB value.
float srgb_from_linear(float value) noexcept;

}  // namespace morphkit::warp
