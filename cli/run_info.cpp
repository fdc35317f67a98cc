#include "cli/cmd_info.h"
#include "morph/media/image_file.h"

namespace morphkit::cli {
namespace {

cv::Size picture_size(const std::filesystem::path& picture) {
  const media::ImageInfo info = media::read_info(picture);
  return {info.width, info.height};
}

}  // namespace

int run_info(const InfoOptions& options, Output& output) {
  const auto info_of = [&](const std::filesystem::path& file) {
    return is_project(file) ? project_info(file, options.changes, picture_size) : picture_info(file, options.pixels);
  };
  return tell(options, info_of, output);
}

}  // namespace morphkit::cli
