#pragma once
// Looking up colours: an image read at the positions that a map gives.

#include "warp/image/image.h"

namespace morphkit::warp {

/// How colours are found. The first three read a point, whatever the map does around it: where it shrinks the picture
/// they alias. The others take the mean over what lies under the output pixel, and are kBicubic where nothing shrinks.
enum class Filter {
  kNearest,
  kBilinear,
  kBicubic,   ///< Catmull-Rom (Keys, a = -1/2)
  kArea,      ///< the mean over the pixel's square
  kMitchell,  ///< Mitchell and Netravali, B = C = 1/3, radius 2 output px: softer
  kLanczos    ///< Lanczos-3, separable, radius 3 output px: sharpest; rings at hard edges
};

/// What lies beyond the edge of the source.
enum class Border {
  kTransparent,  ///< transparent black; the edge is antialiased over one pixel
  kClamp,        ///< the nearest edge pixel
  kMirror        ///< the image reflected at its edge
};

struct SampleOptions {
  Filter filter = Filter::kArea;
  Border border = Border::kTransparent;
};

/// Samples `source` at `map(p)` for every output pixel p.
/// @param source  linear, premultiplied RGBA, any size >= 1x1.
/// @param map     output size; source pixels, centres at i + 0.5; a non-finite position means "nothing there".
/// @return        image of map's size; transparent black where the map says nothing.
/// @throws std::invalid_argument if either is empty.
/// Accuracy: bit-exact where the map hits a pixel centre, for kArea, kMitchell and kLanczos if it does not shrink the
/// picture there; constants are exact; alpha is kept in [0, 1]. Cost: O(pixels x taps), parallel over rows; see
/// bench/sample, and bench/quality for what footprints cost: with the area of the source that they cover.
Image sample(const Image& source, const Map& map, const SampleOptions& options = {});

/// Rows of a frame that are sampled together. Bands start at multiples of this.
inline constexpr int kSampleBand = 32;

/// A band of `sample`, on the calling thread: consecutive rows of the map, into rows of the same size. How far a pixel
/// reaches is told from the positions of this band alone, so the same bands give the same bytes.
void sample_band(const Image& source, const Map& positions, const SampleOptions& options, Image& out) noexcept;

}  // namespace morphkit::warp
