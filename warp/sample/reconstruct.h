#pragma once
// Colours between pixels: reads an image at points, for any distance between them. Internal to warp; tests and
// benchmarks may include it.

#include <span>

#include "warp/image/image.h"
#include "warp/sample/sample.h"

namespace morphkit::warp::detail {

enum class Kernel { kNearest, kBilinear, kBicubic };

/// The colour at each position; no allocation. A position on a pixel centre gives that pixel bit for bit, and a
/// constant image gives its constant. Bicubic is Catmull-Rom, with alpha clamped to [0, 1]. A position's colour does
/// not depend on the positions beside it.
/// @pre the spans have the same length and do not overlap; `source` is not empty.
/// Accuracy: equal to reference_reconstruct_row on every instruction set, but for the sign and payload of NaNs.
/// Cost: see tests/bench/sample_bench.cpp; positions whose taps reach over the border take about twenty times as long.
void reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                     std::span<Pixel> out) noexcept;

/// The specification of reconstruct_row, in plain arithmetic, one position after the other. The kernel calls it at
/// borders.
void reference_reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                               std::span<Pixel> out) noexcept;

}  // namespace morphkit::warp::detail
