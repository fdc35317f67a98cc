#pragma once
// Looking up colours: an image read at the positions that a map gives.

#include <span>

#include "warp/image.h"

namespace morphkit::warp {

enum class Filter { kNearest, kBilinear, kBicubic };

/// What lies beyond the edge of the source.
enum class Border {
  kTransparent,  ///< transparent black; the edge is antialiased over one pixel
  kClamp,        ///< the nearest edge pixel
  kMirror        ///< the image reflected at its edge
};

struct SampleOptions {
  Filter filter = Filter::kBicubic;
  Border border = Border::kTransparent;
};

/// Samples `source` at `map(p)` for every output pixel p.
/// @param source  linear, premultiplied RGBA, any size >= 1x1.
/// @param map     output size; source pixels, centres at i + 0.5; a non-finite position means "nothing there".
/// @return        image of map's size; transparent black where the map says nothing.
/// @throws std::invalid_argument if either is empty.
/// Accuracy: bit-exact where the map hits a pixel centre. Bicubic is Catmull-Rom (Keys, a = -1/2); alpha is kept in
/// [0, 1]. Cost: O(pixels x taps), parallel over rows; see bench/sample.
Image sample(const Image& source, const Map& map, const SampleOptions& options = {});

/// One row of `sample`, on the calling thread. `out` and `positions` have the same length. No allocation.
void sample_row(const Image& source, std::span<const MapPoint> positions, const SampleOptions& options,
                std::span<Pixel> out) noexcept;

}  // namespace morphkit::warp
