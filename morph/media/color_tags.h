#pragma once
// What a picture file says of its colours, and how they become linear light with Rec.709 primaries.

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

#include "morph/media/color_profile.h"
#include "morph/media/image_file.h"
#include "morph/media/pixel_codec.h"

namespace morphkit::media {

struct ColorReading {
  ColorConversion conversion;
  std::string space;    ///< "sRGB", "linear", "gamma 1.8", or the name of the profile that is converted
  std::string told;     ///< what was found and what is done about it, for people
  std::string warning;  ///< what is lost; empty: nothing
};

/// @param colors  colour channels of the picture as stored: 1 gray, 3 RGB, 4 CMYK.
/// @param space   overrides what the file says.
ColorReading color_reading(const OIIO::ImageSpec& spec, int colors, ColorSpace space);

}  // namespace morphkit::media
