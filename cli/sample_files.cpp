#include "cli/sample_files.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "morph/error.h"
#include "morph/media/atomic_file.h"
#include "morph/media/image_file.h"
#include "samples/write.h"
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
  const warp::Image image = samples::image_of(picture);
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

std::filesystem::path write_sample(const samples::Sample& sample, const std::filesystem::path& folder, bool overwrite) {
  make_folder(folder);
  for (const samples::PaintedPicture& picture : sample.pictures) write_picture(picture, folder, overwrite);
  const std::filesystem::path project_file = folder / (sample.name + ".json");
  write_project(sample.project, project_file, overwrite);
  return project_file;
}

}  // namespace morphkit::cli
