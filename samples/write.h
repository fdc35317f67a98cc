#pragma once
// Writes a sample as files: its pictures, and the project beside them.

#include <filesystem>
#include <string>
#include <utility>

#include "base/error.h"
#include "samples/samples.h"
#include "warp/image/image.h"

namespace morphkit::samples {

/// A file that is there and has other contents than the sample's.
class ChangedFile : public Error {
 public:
  explicit ChangedFile(std::string place)
      : Error(ErrorKind::kIo, std::move(place), "exists and is not what the demo writes") {}
};

/// The picture in the form of the rest of morphkit: linear, premultiplied.
warp::Image image_of(const PaintedPicture& picture);

/// Writes the pictures as PNG and the project as <name>.json into `folder`, which is made if missing. A file that
/// already has the same contents stays untouched.
/// @return  the project file.
/// @throws Error kIo; ChangedFile if a file with other contents exists and `overwrite` is off: it may be somebody's
/// work.
std::filesystem::path write(const Sample& sample, const std::filesystem::path& folder, bool overwrite);

}  // namespace morphkit::samples
