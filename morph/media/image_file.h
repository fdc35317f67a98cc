#pragma once
// Still images in files. Only this folder uses OpenImageIO. Colour and alpha are converted here, once: images are read
// as linear, premultiplied float RGBA with Rec.709
// primaries, and written in the form of the file format.

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::media {

enum class ColorSpace {
  kAuto,  ///< as the file says; without a tag, 8 and 16 bit are sRGB and float is linear
  kSrgb,
  kLinear
};

/// "auto" | "srgb" | "linear". @throws Error kUnsupported naming the choices.
ColorSpace color_space_from(const std::string& name);

/// Facts about a file, from its header alone.
struct ImageInfo {
  std::filesystem::path file;
  std::string format;         ///< "png", "openexr", ...
  int width = 0, height = 0;  ///< px, after EXIF orientation
  int channels = 0;
  bool has_alpha = false;
  bool ignores_alpha = false;  ///< the last channel may be alpha, but the header does not say so
  std::string channel_type;    ///< "uint8", "uint16", "half", "float"
  std::string color_space;     ///< how it is read: "sRGB", "linear", a profile's name
  std::string color_told;      ///< what the file says of its colours and what is done
  std::string color_warning;   ///< what of that is not obeyed; empty: nothing
  int orientation = 1;         ///< EXIF, 1..8, as stored
  std::int64_t bytes = 0;      ///< file size
  std::vector<std::pair<std::string, std::string>> metadata;  ///< everything else, as text, in the order of the file
};

/// Metadata of a source that its frames inherit. Opaque outside morph/media.
class Metadata;

struct Picture {
  warp::Image image;
  ImageInfo info;
  std::int64_t nonfinite_pixels = 0;      ///< pixels with NaN or infinity, replaced by transparent black
  std::int64_t alpha_outside_pixels = 0;  ///< pixels with alpha outside [0, 1], which is clamped
  std::int64_t above_alpha_pixels = 0;    ///< pixels of a premultiplied integer file with colour clamped to alpha
  bool transparent_everywhere = false;
  std::shared_ptr<const Metadata> metadata;
};

/// For programs of our own, once, before they use pictures: makes OpenImageIO work in the calling thread only (frames
/// run in parallel) and turns its own limit on sizes off. These are attributes of the process, so a guest leaves them.
void set_up_process();

/// @throws Error kIo (missing, unreadable, a directory) kBadInput (truncated, too large) or kUnsupported (not an
/// image).
ImageInfo read_info(const std::filesystem::path& file);
Picture read_picture(const std::filesystem::path& file, ColorSpace space = ColorSpace::kAuto);

/// What a person should know about the pixels, a sentence without the file's name each; usually none.
std::vector<std::string> warnings_of(const Picture& picture);

/// How pixels are stored; kAuto is the format's usual type (PNG, JPEG, WebP, TGA, GIF 8 bit; TIFF 16; EXR half).
enum class Depth { kAuto, k8, k16, kHalf, kFloat };

/// "auto" | "8" | "16" | "half" | "float". @throws Error kUnsupported.
Depth depth_from(const std::string& name);

struct WriteOptions {
  Depth depth = Depth::kAuto;
  int compression = -1;                      ///< PNG, TIFF, EXR: 0 none .. 9 smallest; -1: fast (image_writer.cpp)
  int quality = 95;                          ///< JPEG and WebP, 1..100; 100 is lossless for WebP
  std::optional<bool> alpha;                 ///< store alpha if the format can; unset: only if a pixel is not opaque
  std::shared_ptr<const Metadata> metadata;  ///< written if given
  std::string software;                      ///< if not empty, the "Software" of PNG, JPEG, TIFF, EXR and TGA files
  bool overwrite = false;
};

/// Refuses options that are impossible for every image of this name. @throws Error kUnsupported.
void check_write_options(const std::filesystem::path& name, const WriteOptions& options);

/// Writes one image, atomically: a temporary name beside it, then a rename. Formats without alpha get the image over
/// black. @throws Error kIo; kUnsupported for an unknown extension or a depth that the format does not support; kIo if
/// the file exists and overwrite is off.
void write_image(const std::filesystem::path& file, const warp::Image& image, const WriteOptions& options = {});

/// The bytes that write_image would write to a file of this name; it does not touch the file. Thread-safe. @throws
/// Error kUnsupported as write_image does, kFailed if the codec fails.
std::vector<std::uint8_t> encode_image(const std::filesystem::path& name, const warp::Image& image,
                                       const WriteOptions& options = {});

/// Writes two channels R, G as a 32-bit float EXR (an STMap), atomically. Values are not colour-converted.
void write_map(const std::filesystem::path& file, const warp::Map& map, bool overwrite);

/// Whether write_image supports the file's extension.
bool is_image_extension(const std::filesystem::path& file);

}  // namespace morphkit::media
