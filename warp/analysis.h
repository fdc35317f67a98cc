#pragma once
// What a map does to the plane: folds and local magnification, from J = d(source)/d(output) by differences.

#include <cstdint>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::warp {

/// A connected set (8-neighbourhood) of output pixels where the map folds over.
struct FoldRegion {
  std::int64_t area_px = 0;  ///< number of folded output pixels
  cv::Rect bounds;           ///< output pixels
  cv::Point2d centroid;      ///< output position
};

/// Stretch of the map over all its finite pixels: singular values of J. 1 is unchanged, above 1 minified (several
/// source pixels per output pixel), below 1 magnified.
struct StretchRange {
  double smallest = 1;
  double largest = 1;
};

/// det J per output pixel, central differences inside, one-sided at the border. An axis of a single pixel has no
/// difference: J is the identity along it. NaN where the map or a neighbour in use is not finite.
/// Same size as the map.
cv::Mat1f jacobian_determinant(const Map& map);

/// Singular values of J per output pixel, (larger, smaller). Size of map; NaN as above.
cv::Mat2f stretch(const Map& map);

/// Regions where det J <= 0, largest first, ties by position. Pixels with det J = NaN belong to no region.
std::vector<FoldRegion> find_folds(const Map& map);

/// Over all finite pixels; (1, 1) if there are none.
StretchRange stretch_range(const Map& map);

}  // namespace morphkit::warp
