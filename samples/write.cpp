#include "samples/write.h"

#include <cstdint>
#include <span>

#include "morph/media/atomic_file.h"
#include "morph/media/image_file.h"
#include "warp/color.h"

namespace morphkit::samples {

warp::Image image_of(const PaintedPicture& picture) {
  warp::Image image(picture.pixels.size());
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec4b straight = picture.pixels(y, x);
      const float alpha = static_cast<float>(straight[3]) / 255;
      for (int c = 0; c < 3; ++c)
        image(y, x)[c] = warp::linear_from_srgb(static_cast<float>(straight[c]) / 255) * alpha;
      image(y, x)[3] = alpha;
    }
  return image;
}

std::filesystem::path write(const std::string& name, const std::filesystem::path& folder, bool overwrite) {
  const Sample sample = paint(name);
  media::WriteOptions options;
  options.overwrite = overwrite;
  for (const PaintedPicture& picture : sample.pictures)
    media::write_image(folder / picture.name, image_of(picture), options);
  const std::filesystem::path project = folder / (sample.name + ".json");
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(sample.project.data());
  media::write_file(project, {bytes, sample.project.size()}, overwrite);
  return project;
}

}  // namespace morphkit::samples
