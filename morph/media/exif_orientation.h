#pragma once
// Which way is up, by the Exif data of a picture.

#include <cstdint>
#include <optional>
#include <span>

namespace morphkit::media {

/// @param tiff  the Exif data from their byte order mark on (Exif 2.3, 4.5: as a TIFF file).
/// @return  the orientation 1 to 8 of the first directory; 1 where it says none or one that there is not. Nothing if
///          the data are not as they should be.
std::optional<int> exif_orientation(std::span<const std::uint8_t> tiff);

}  // namespace morphkit::media
