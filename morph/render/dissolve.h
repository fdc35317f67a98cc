#pragma once
// Mixes one row of two pictures, and puts it over the background.

#include <span>

#include "morph/project/project.h"
#include "warp/image/image.h"

namespace morphkit::render {

/// C = (1 - alpha) S + alpha D on premultiplied rows of equal length, written to `source`. Where alpha is 0 or 1 the
/// result is that picture bit for bit. `alpha` has one value per pixel, or a single value for all pixels.
void dissolve_row(std::span<warp::Pixel> source, std::span<const warp::Pixel> destination, std::span<const float> alpha,
                  project::Blend blend) noexcept;

/// `row` over `behind` (Porter & Duff 1984), in place. `behind` has row's length, or length 1 for a plain colour.
void over_row(std::span<warp::Pixel> row, std::span<const warp::Pixel> behind) noexcept;

}  // namespace morphkit::render
