#include "morph/media/image_file.h"

#include <fmt/format.h>

#include "base/error.h"
#include "morph/media/image_format.h"
#include "morph/media/image_reader.h"

namespace morphkit::media {

ColorSpace color_space_from(const std::string& name) {
  if (name == "auto") return ColorSpace::kAuto;
  if (name == "srgb") return ColorSpace::kSrgb;
  if (name == "linear") return ColorSpace::kLinear;
  throw Error(ErrorKind::kUnsupported, "", fmt::format("\"{}\" is no color space; use auto, srgb or linear", name));
}

Depth depth_from(const std::string& name) {
  if (name == "auto") return Depth::kAuto;
  if (name == "8") return Depth::k8;
  if (name == "16") return Depth::k16;
  if (name == "half") return Depth::kHalf;
  if (name == "float") return Depth::kFloat;
  throw Error(ErrorKind::kUnsupported, "", fmt::format("\"{}\" is no depth; use auto, 8, 16, half or float", name));
}

ImageInfo read_info(const std::filesystem::path& file) {
  return ImageReader(file).info(ColorSpace::kAuto);
}

Picture read_picture(const std::filesystem::path& file, ColorSpace space) {
  ImageReader reader(file);
  Picture picture;
  picture.image = reader.read(space, picture.nonfinite_pixels);
  picture.info = reader.info(space);
  picture.metadata = reader.metadata();
  return picture;
}

bool is_image_extension(const std::filesystem::path& file) {
  return writable_format(file) != nullptr;
}

}  // namespace morphkit::media
