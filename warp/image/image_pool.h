#pragma once
// Memory for images that come and go with every frame.

#include <cstddef>

#include "warp/image/image.h"

namespace morphkit::warp {

/// An image with arbitrary contents. When its last reference goes, its memory is kept for the next image that needs as
/// much: an image of a few megapixels is above what the C library keeps, so a fresh one would be mapped and zeroed page
/// by page each time, which takes longer than many warps. Thread-safe. At most kKeptBytes wait unused.
Image pooled_image(cv::Size size);

inline constexpr std::size_t kKeptBytes = std::size_t{256} << 20;

}  // namespace morphkit::warp
