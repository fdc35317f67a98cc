#pragma once
// What the header of a file says about a fourth (or second) channel, where the picture library does not tell.

#include <filesystem>
#include <string>

namespace morphkit::media {

enum class DeclaredAlpha {
  kLibraryKnows,   ///< not BMP or TGA
  kNone,           ///< the channel is not alpha
  kStraight,       ///< alpha; colours are stored without it
  kPremultiplied,  ///< alpha, by which stored colours were multiplied
};

/// BMP: the fourth byte of a pixel is alpha if the header has a mask for it or if any is above 0; GDI leaves zeros
/// there. TGA: the extension area decides if there is one, else the number of alpha bits in the descriptor.
/// A file that cannot be read has no alpha. Cost: of a BMP without a mask, the rows up to the first alpha above 0.
/// Truevision TGA File Format Specification 2.0, fields 5.6 and 24.
DeclaredAlpha declared_alpha(const std::filesystem::path& file, const std::string& format);

}  // namespace morphkit::media
