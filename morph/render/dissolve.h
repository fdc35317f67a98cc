#pragma once
// Mixing one row of two pictures, and laying it over what is behind.

#include <span>

#include "morph/project/project.h"
#include "warp/image/image.h"

namespace morphkit::render {

/// C = (1 - alpha) S + alpha D on premultiplied rows of equal length, in place of `source`. Where alpha is 0 or 1 the
/// result is that picture bit for bit. alpha has the rows' length, or length 1 for all pixels.
void dissolve_row(std::span<warp::Pixel> source, std::span<const warp::Pixel> destination, std::span<const float> alpha,
                  project::Blend blend) noexcept;

/// `row` over `behind` (Porter & Duff 1984), in place. `behind` has row's length, or length 1 for a plain colour.
void over_row(std::span<warp::Pixel> row, std::span<const warp::Pixel> behind) noexcept;

}  // namespace morphkit::render
