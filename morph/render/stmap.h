#pragma once
// STMaps: a map as compositors read it (Nuke, Fusion, Natron, Flame).

#include "warp/image/image.h"

namespace morphkit::render {

/// Where (0, 0) lies in an STMap. Compositors say bottom left; OpenImageIO's st_warp says top left.
enum class Origin { kBottomLeft, kTopLeft };

/// The map with positions as fractions of the source's size: (0, 0) and (1, 1) are the outer corners of its corner
/// pixels, so that the centre of the first pixel is at 0.5 / width. Rows stay where they are: only the values know the
/// origin. NaN stays NaN.
/// @param map          source pixels.
/// @param source_size  px.
warp::Map stmap(const warp::Map& map, cv::Size source_size, Origin origin = Origin::kBottomLeft);

}  // namespace morphkit::render
