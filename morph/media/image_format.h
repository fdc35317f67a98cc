#pragma once
// Image formats: recognises them by the first bytes of a file, and lists what each written format supports.

#include <filesystem>
#include <string>
#include <vector>

#include "morph/media/image_file.h"

namespace morphkit::media {

/// A format that morphkit writes.
struct WritableFormat {
  std::string plugin;              ///< OpenImageIO's name
  std::string shown;               ///< the name that people use
  std::vector<std::string> names;  ///< extensions, lower case, with the dot
  std::vector<Depth> depths;       ///< supported depths; the first is the usual one
  bool alpha = false;
  int largest_side = 0;           ///< px
  bool compression = false;       ///< whether it has levels of compression
  bool carries_software = false;  ///< whether a file says what wrote it
};

/// The format of the file's extension, in upper or lower case; null if morphkit does not write it.
const WritableFormat* writable_format(const std::filesystem::path& file);

/// ".png .tif ...": every extension of writable_format.
std::string writable_extensions();

/// The format of `file` by its first bytes ("png", "openexr", ...). TGA has no such bytes and goes by its extension.
/// @throws Error kIo if it is missing, a folder or unreadable; kBadInput if it is empty; kUnsupported if the format
///         is unknown.
std::string sniff_format(const std::filesystem::path& file);

/// "8 bit" | "16 bit" | "half" | "float".
std::string shown_depth(Depth depth);

/// Readers check these limits before they allocate anything.
struct ImageLimits {
  std::int64_t pixels = std::int64_t{1} << 30;
  int side = 65536;     ///< px
  int channels = 1024;  ///< EXR files of renderers have hundreds
};

/// The limits in force; set_image_limits replaces them (for fuzzing and tests; not while files are being read).
const ImageLimits& image_limits();
void set_image_limits(const ImageLimits& limits);

/// @throws Error kBadInput with the size and the limit if a size in the header is 0 or above its limit.
void check_size(const std::filesystem::path& file, std::int64_t width, std::int64_t height, std::int64_t channels);

}  // namespace morphkit::media
