#pragma once
// What is carried from a source file to the frames made from it, and what is not because it would lie.

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace morphkit::media {

/// Attributes of a file that still hold for pictures made from it: Exif, IPTC, XMP, resolution, copyright, description,
/// time codes, camera. Left out: what describes the storage of the old file (compression, tiles, parts), orientation
/// and sizes (the pixels have been turned already), and the ICC profile and chromaticities: what morphkit writes is
/// tagged sRGB or linear by itself.
class Metadata {
 public:
  explicit Metadata(const OIIO::ImageSpec& spec);

  /// Adds the attributes to `spec`. The times and the colour space that OpenImageIO would make up are never made up.
  void apply(OIIO::ImageSpec& spec) const;

 private:
  OIIO::ParamValueList attributes_;
};

/// Everything that the header says, as text, for people; long values are cut.
std::vector<std::pair<std::string, std::string>> metadata_text(const OIIO::ImageSpec& spec);

}  // namespace morphkit::media
