#pragma once
// Colours between pixels: an image read at points, whatever the distance between them. Internal to warp; tests and
// benchmarks may look inside.

#include <span>

#include "warp/image.h"
#include "warp/sample.h"

namespace morphkit::warp::detail {

enum class Kernel { kNearest, kBilinear, kBicubic };

/// The colour at each position; no allocation. A position on a pixel centre gives that pixel to the bit, and a constant
/// image gives its constant.
/// @pre the spans have one length; `source` is not empty.
void reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                     std::span<Pixel> out) noexcept;

}  // namespace morphkit::warp::detail
