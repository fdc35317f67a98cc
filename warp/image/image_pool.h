#pragma once
// Memory for images that live for one frame.

#include <cstddef>

#include "warp/image/image.h"

namespace morphkit::warp {

/// An image with arbitrary contents. When its last reference goes, its memory is kept for the next image of that size.
/// The C library does not keep blocks of several megapixels: it would map and zero each new image page by page, which
/// takes longer than many warps. Thread-safe. At most kKeptBytes are kept unused.
Image pooled_image(cv::Size size);

inline constexpr std::size_t kKeptBytes = std::size_t{256} << 20;

}  // namespace morphkit::warp
