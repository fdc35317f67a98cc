#pragma once
// A sample as files: its pictures, and the project beside them.

#include <filesystem>
#include <string>

#include "samples/samples.h"
#include "warp/image.h"

namespace morphkit::samples {

/// The picture as the rest of morphkit knows pictures: linear, premultiplied.
warp::Image image_of(const PaintedPicture& picture);

/// Paints a sample and writes its PNG files and `<name>.json` into an existing folder. @return the project file.
/// @throws std::invalid_argument for an unknown name; Error kIo if a file cannot be written, or exists and `overwrite`
/// is false.
std::filesystem::path write(const std::string& name, const std::filesystem::path& folder, bool overwrite);

}  // namespace morphkit::samples
