#pragma once
// Linear light to screen colours.

#include <opencv2/core.hpp>

#include "warp/image/image.h"

namespace morphkit::edit {

/// BGR in sRGB; transparent pixels over a checkerboard of two greys. Parallel over rows.
cv::Mat3b to_screen(const warp::Image& image);

}  // namespace morphkit::edit
