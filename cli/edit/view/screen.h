#pragma once
// From light to what a screen shows.

#include <opencv2/core.hpp>

#include "warp/image/image.h"

namespace morphkit::edit {

/// BGR, sRGB codes; what is transparent lies over a checkerboard of two greys. Parallel over rows.
cv::Mat3b to_screen(const warp::Image& image);

}  // namespace morphkit::edit
