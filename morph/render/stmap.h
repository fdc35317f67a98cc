#pragma once
// STMaps: maps in the form of compositors (Nuke, Fusion, Natron, Flame).

#include "warp/image/image.h"

namespace morphkit::render {

/// The corner with (0, 0) in an STMap: bottom left in compositors, top left in OpenImageIO's st_warp.
enum class Origin { kBottomLeft, kTopLeft };

/// The map with positions as fractions of the source's size: (0, 0) and (1, 1) are the outer corners of its corner
/// pixels, so the centre of the first pixel is at 0.5 / width. Rows stay in place: the origin changes only the values.
/// NaN stays NaN.
/// @param map          source pixels.
/// @param source_size  px.
warp::Map stmap(const warp::Map& map, cv::Size source_size, Origin origin = Origin::kBottomLeft);

}  // namespace morphkit::render
