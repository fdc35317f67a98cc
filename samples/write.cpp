#include "samples/write.h"

#include <cstdint>
#include <string>
#include <system_error>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/whole_file.h"
#include "morph/media/image_file.h"
#include "warp/image/color.h"
#include "warp/image/compare.h"

namespace morphkit::samples {
namespace {

/// Far below one step of an 8-bit file: a smaller difference is the same picture.
constexpr double kSamePicture = 1e-4;

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorKind::kIo, folder.string(), "cannot make the folder: " + error.message());
}

bool holds_picture(const std::filesystem::path& file, const warp::Image& image) {
  try {
    const warp::Image there = media::read_picture(file).image;
    return there.size() == image.size() && warp::compare(there, image).within(kSamePicture);
  } catch (const Error&) {
    return false;
  }
}

void write_picture(const PaintedPicture& picture, const std::filesystem::path& folder, bool overwrite) {
  const std::filesystem::path file = folder / picture.name;
  const warp::Image image = image_of(picture);
  if (!overwrite && std::filesystem::exists(file)) {
    if (!holds_picture(file, image)) throw ChangedFile(file.string());
    return;
  }
  media::WriteOptions options;
  options.depth = media::Depth::k8;
  options.overwrite = overwrite;
  media::write_image(file, image, options);
}

void write_project(const std::string& text, const std::filesystem::path& file, bool overwrite) {
  if (!overwrite && std::filesystem::exists(file)) {
    if (read_file(file, "project") != text) throw ChangedFile(file.string());
    return;
  }
  write_file(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, overwrite);
}

}  // namespace

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

std::filesystem::path write(const Sample& sample, const std::filesystem::path& folder, bool overwrite) {
  make_folder(folder);
  for (const PaintedPicture& picture : sample.pictures) write_picture(picture, folder, overwrite);
  std::filesystem::path project_file = folder / (sample.name + ".json");
  write_project(sample.project, project_file, overwrite);
  return project_file;
}

}  // namespace morphkit::samples
