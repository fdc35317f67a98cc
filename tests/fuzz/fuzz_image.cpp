// Reads any bytes as an image: the result is a picture or an Error, nothing else. The first byte chooses the extension
// (only TGA depends on it), the rest is the file.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "morph/media/image_format.h"

namespace {

using morphkit::media::ImageLimits;

const std::filesystem::path& folder() {
  static const std::filesystem::path path = [] {
    const auto name = std::filesystem::temp_directory_path() / ("fuzz_image_" + std::to_string(::getpid()));
    std::filesystem::create_directories(name);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    // Small pictures find the same faults as large ones, but sooner.
    morphkit::media::set_image_limits(ImageLimits{1 << 18, 4096, 16});
    return name;
  }();
  return path;
}

void check_finite(const morphkit::warp::Image& image) {
  for (const morphkit::warp::Pixel& pixel : image) {
    for (int c = 0; c < 4; ++c) {
      if (!std::isfinite(pixel[c])) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::filesystem::path file = folder() / (data[0] % 2 == 0 ? "input.png" : "input.tga");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  try {
    const morphkit::media::ImageInfo info = morphkit::media::read_info(file);
    const morphkit::media::Picture picture = morphkit::media::read_picture(file);
    if (picture.image.cols != info.width || picture.image.rows != info.height) std::abort();
    check_finite(picture.image);
  } catch (const morphkit::Error& error) {
    if (std::string(error.what()).empty()) std::abort();
  }
  return 0;
}
