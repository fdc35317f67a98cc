#include "morph/render/stmap.h"

namespace morphkit::render {

warp::Map stmap(const warp::Map& map, cv::Size source_size, Origin origin) {
  warp::Map result(map.size());
  const auto width = static_cast<double>(source_size.width);
  const auto height = static_cast<double>(source_size.height);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const warp::MapPoint& position = map(y, x);
      const double t = position[1] / height;
      result(y, x) = {static_cast<float>(position[0] / width),
                      static_cast<float>(origin == Origin::kBottomLeft ? 1 - t : t)};
    }
  return result;
}

}  // namespace morphkit::render
