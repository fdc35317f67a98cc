#pragma once
// Sampling: reads an image at the positions of a map.

#include "warp/image/image.h"

namespace morphkit::warp {

/// How colours are found. The first three read a point and alias where the map shrinks the picture. The others take the
/// mean over the source area under the output pixel, and are kBicubic where nothing shrinks.
enum class Filter {
  kNearest,
  kBilinear,
  kBicubic,   ///< Catmull-Rom (Keys, a = -1/2)
  kArea,      ///< the mean over the pixel's square
  kMitchell,  ///< Mitchell and Netravali, B = C = 1/3, radius 2 output px: softer
  kLanczos    ///< Lanczos-3, separable, radius 3 output px: sharpest; rings at hard edges
};

/// The colours beyond the edge of the source.
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
/// @return        image of the map's size; transparent black where the map is not finite.
/// @throws std::invalid_argument if either is empty.
/// Accuracy: bit-exact where the map hits a pixel centre (for kArea, kMitchell and kLanczos: if it does not shrink the
/// picture there); constants are exact; alpha is clamped to [0, 1]. Cost: O(pixels x taps), parallel over rows;
/// footprints cost in proportion to their area. See tests/bench/sample_bench.cpp and quality_bench.cpp.
Image sample(const Image& source, const Map& map, const SampleOptions& options = {});

/// Rows of a frame that are sampled together. Bands begin at multiples of this.
inline constexpr int kSampleBand = 32;

/// A band of `sample`, on the calling thread: consecutive rows of the map, into rows of the same size. Footprints
/// depend on the positions of this band alone, so the same bands give the same bytes.
void sample_band(const Image& source, const Map& positions, const SampleOptions& options, Image& out) noexcept;

}  // namespace morphkit::warp
