#include "morph/media/metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace morphkit::media {
namespace {

constexpr std::array<std::string_view, 11> kStoragePrefixes = {
    "oiio:", "tiff:", "png:", "jpeg:", "openexr:", "webp:", "gif:", "bmp:", "heif:", "psd:", "targa:"};

constexpr std::array<std::string_view, 32> kUntrueNames = {"Orientation",
                                                           "Exif:Orientation",
                                                           "ICCProfile",
                                                           "chromaticities",
                                                           "Exif:ColorSpace",
                                                           "Exif:Gamma",
                                                           "Exif:PixelXDimension",
                                                           "Exif:PixelYDimension",
                                                           "compression",
                                                           "planarconfig",
                                                           "CompressionQuality",
                                                           "thumbnail_width",
                                                           "thumbnail_height",
                                                           "thumbnail_image",
                                                           "thumbnail_nchannels",
                                                           "preview",
                                                           "name",
                                                           "type",
                                                           "version",
                                                           "chunkCount",
                                                           "view",
                                                           "multiView",
                                                           "tiles",
                                                           "textureformat",
                                                           "wrapmodes",
                                                           "screenWindowCenter",
                                                           "screenWindowWidth",
                                                           "PixelAspectRatio",
                                                           "dwaCompressionLevel",
                                                           "lineOrder",
                                                           "ICCProfile:",
                                                           "maxSamplesPerPixel"};

constexpr std::size_t kLongestText = 200;  // characters
constexpr std::size_t kMostValues = 32;

bool starts_with_any(std::string_view name) {
  return std::any_of(kStoragePrefixes.begin(), kStoragePrefixes.end(),
                     [&](std::string_view prefix) { return name.starts_with(prefix); }) ||
         name.starts_with("ICCProfile");
}

bool is_carried(std::string_view name) {
  return !starts_with_any(name) && std::find(kUntrueNames.begin(), kUntrueNames.end(), name) == kUntrueNames.end();
}

}  // namespace

Metadata::Metadata(const OIIO::ImageSpec& spec) {
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    if (is_carried(attribute.name().string())) attributes_.push_back(attribute);
  }
}

void Metadata::apply(OIIO::ImageSpec& spec) const {
  for (const OIIO::ParamValue& attribute : attributes_) spec.extra_attribs.add_or_replace(attribute);
}

std::vector<std::pair<std::string, std::string>> metadata_text(const OIIO::ImageSpec& spec) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    const std::size_t values = attribute.type().numelements() * static_cast<std::size_t>(attribute.nvalues());
    std::string text;
    if (values > kMostValues) {
      text = fmt::format("{} values of type {}", values, attribute.type().elementtype().c_str());
    } else {
      text = attribute.get_string();
    }
    if (text.size() > kLongestText) text = text.substr(0, kLongestText) + "...";
    result.emplace_back(name, text);
  }
  return result;
}

}  // namespace morphkit::media
