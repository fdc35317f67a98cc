#pragma once
// The metadata that frames inherit from a source file. Attributes that would be wrong for them are left out.

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace morphkit::media {

/// Attributes of a file that are still true for pictures made from it: Exif, IPTC, XMP, resolution, copyright,
/// description, time codes, camera. Left out: the storage of the old file (compression, tiles, parts), orientation and
/// sizes (the pixels are already upright), and the ICC profile and chromaticities (morphkit tags its files as sRGB or
/// linear itself).
class Metadata {
 public:
  explicit Metadata(const OIIO::ImageSpec& spec);

  /// Adds the attributes to `spec`. It suppresses the times and the colour space that OpenImageIO would invent.
  void apply(OIIO::ImageSpec& spec) const;

 private:
  OIIO::ParamValueList attributes_;
};

/// All attributes of the header as text, for people; long values are cut.
std::vector<std::pair<std::string, std::string>> metadata_text(const OIIO::ImageSpec& spec);

}  // namespace morphkit::media
