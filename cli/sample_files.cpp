#include "cli/sample_files.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "morph/error.h"
#include "morph/media/atomic_file.h"
#include "morph/media/image_file.h"
#include "warp/color.h"
#include "warp/compare.h"

namespace morphkit::cli {
namespace {

/// Far below one step of an 8-bit file: the file holds the same picture.
constexpr double kSamePicture = 1e-4;

[[noreturn]] void fail_changed(const std::filesystem::path& file) {
  throw Error(ErrorCode::kIo, file.string(),
              "exists and is not what the demo writes; -y replaces it, -o writes into another folder");
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorCode::kIo, folder.string(), "cannot make the folder: " + error.message());
}

bool holds_picture(const std::filesystem::path& file, const warp::Image& image) {
  try {
    const warp::Image there = media::read_picture(file).image;
    return there.size() == image.size() && warp::compare(there, image).within(kSamePicture);
  } catch (const Error&) {
    return false;
  }
}

void write_picture(const samples::PaintedPicture& picture, const std::filesystem::path& folder, bool overwrite) {
  const std::filesystem::path file = folder / picture.name;
  const warp::Image image = linear_from_painted(picture.pixels);
  if (!overwrite && std::filesystem::exists(file)) {
    if (!holds_picture(file, image)) fail_changed(file);
    return;
  }
  media::WriteOptions options;
  options.depth = media::Depth::k8;
  options.overwrite = overwrite;
  media::write_image(file, image, options);
}

void write_project(const std::string& text, const std::filesystem::path& file, bool overwrite) {
  if (!overwrite && std::filesystem::exists(file)) {
    std::ifstream stream(file, std::ios::binary);
    const std::string there{std::istreambuf_iterator<char>(stream), {}};
    if (there != text) fail_changed(file);
    return;
  }
  media::write_file(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, overwrite);
}

}  // namespace

warp::Image linear_from_painted(const cv::Mat4b& painted) {
  std::array<float, 256> linear{};
  for (std::size_t value = 0; value < linear.size(); ++value) {
    linear[value] = warp::linear_from_srgb(static_cast<float>(value) / 255.0F);
  }
  warp::Image image(painted.size());
  for (int y = 0; y < painted.rows; ++y) {
    for (int x = 0; x < painted.cols; ++x) {
      const cv::Vec4b& from = painted(y, x);
      const float alpha = static_cast<float>(from[3]) / 255.0F;
      image(y, x) = {linear[from[0]] * alpha, linear[from[1]] * alpha, linear[from[2]] * alpha, alpha};
    }
  }
  return image;
}

std::filesystem::path write_sample(const samples::Sample& sample, const std::filesystem::path& folder, bool overwrite) {
  make_folder(folder);
  for (const samples::PaintedPicture& picture : sample.pictures) write_picture(picture, folder, overwrite);
  const std::filesystem::path project_file = folder / (sample.name + ".json");
  write_project(sample.project, project_file, overwrite);
  return project_file;
}

}  // namespace morphkit::cli
