#include "morph/media/image_file.h"

#include <fmt/format.h>

#include <algorithm>

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
  PixelFaults faults;
  picture.image = reader.read(space, faults);
  picture.nonfinite_pixels = faults.nonfinite;
  picture.alpha_outside_pixels = faults.alpha_outside;
  picture.above_alpha_pixels = faults.above_alpha;
  picture.transparent_everywhere =
      std::none_of(picture.image.begin(), picture.image.end(), [](const warp::Pixel& pixel) { return pixel[3] > 0; });
  picture.info = reader.info(space);
  picture.metadata = reader.metadata();
  return picture;
}

std::vector<std::string> warnings_of(const Picture& picture) {
  std::vector<std::string> warnings;
  const auto warn_of = [&](std::int64_t pixels, const char* what) {
    if (pixels > 0) warnings.push_back(fmt::format("{} pixels {}", pixels, what));
  };
  warn_of(picture.nonfinite_pixels, "are NaN or infinite; they are taken as nothing there");
  warn_of(picture.alpha_outside_pixels, "have alpha below 0 or above 1; it is clamped");
  warn_of(picture.above_alpha_pixels,
          "are brighter than their alpha, although the file says that it is premultiplied; they are clamped to alpha");
  if (!picture.info.color_warning.empty()) warnings.push_back(picture.info.color_warning);
  if (picture.info.ignores_alpha) warnings.emplace_back("the header declares no alpha, so the last channel is ignored");
  if (picture.transparent_everywhere) warnings.emplace_back("the picture is transparent everywhere");
  return warnings;
}

bool is_image_extension(const std::filesystem::path& file) {
  return writable_format(file) != nullptr;
}

}  // namespace morphkit::media
