#pragma once
// The pictures of a project as rendering needs them. This folder does not open them: morph/job reads files,
// the editor keeps pyramids, a program may paint in memory.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::render {

/// One picture: its own size, and a copy to start from for a given display scale: the picture itself, or a smaller copy
/// that is still at least as large as shown. Linear, premultiplied.
struct FootagePicture {
  cv::Size size;
  std::function<warp::Image(double scale)> at;
  bool has_alpha = false;  ///< whether a pixel may be transparent
};

/// A picture in one size. Its pixels are shared, not copied.
inline FootagePicture in_memory(const warp::Image& image, bool has_alpha = false) {
  return {image.size(), [image](double) { return image; }, has_alpha};
}

struct Footage {
  std::vector<FootagePicture> pictures;  ///< in the order of Project::pictures
  std::optional<FootagePicture> background;
};

}  // namespace morphkit::render
