#pragma once
// The implementation of read_info and read_picture: an open file and its header.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "morph/media/color_tags.h"
#include "morph/media/declared_alpha.h"
#include "morph/media/image_file.h"
#include "morph/media/pixel_codec.h"

namespace morphkit::media {

/// One image of a file: the first part, if there are several. The first bytes decide the format, not the extension.
class ImageReader {
 public:
  /// @throws Error as read_info does; limits are checked before anything of the picture's size is allocated.
  explicit ImageReader(const std::filesystem::path& file);

  /// @param space  overrides the colour space that the file states.
  ImageInfo info(ColorSpace space) const;
  std::shared_ptr<const Metadata> metadata() const;

  /// The pixels, upright.
  warp::Image read(ColorSpace space, PixelFaults& faults);

 private:
  void open();
  void check() const;
  bool is_display_window() const;
  void choose_channels();
  void choose_alpha();
  ColorReading color(ColorSpace space) const;
  StoredLayout layout(ColorSpace space) const;
  void read_rows(int begin, int end, const OIIO::TypeDesc& type, void* data);
  warp::Image read_stored(const PixelDecoder& decoder, PixelFaults& faults);
  warp::Image read_webp(const PixelDecoder& decoder);
  warp::Image to_display_window(const warp::Image& data_window) const;

  std::filesystem::path file_;
  std::string format_;
  std::vector<std::uint8_t> bytes_;                        ///< the whole file, if it was checked first
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_;  ///< outlives input_
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
  DeclaredAlpha declared_alpha_ = DeclaredAlpha::kLibraryKnows;
  int orientation_ = 1;
  int r_ = -1, g_ = -1, b_ = -1, a_ = -1;  ///< channels of the file; -1: none
  int channel_begin_ = 0, channel_end_ = 0;
};

}  // namespace morphkit::media
