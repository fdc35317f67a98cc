#pragma once
// ICC profiles, through Little CMS. A build without it reads none and says so.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "warp/image/image.h"

namespace morphkit::media {

/// The way from the values of a profile to linear light with Rec.709 primaries: relative colorimetric, with black point
/// compensation. Values outside 0..1 stay. Thread-safe.
class ProfileTransform {
 public:
  virtual ~ProfileTransform() = default;

  /// @param pixels  stored values, unpremultiplied, 0..1: gray in the first element, RGB in the first three, or CMYK
  ///                (1 is full ink). Each becomes linear RGB; gray and RGB keep the fourth element.
  virtual void apply(std::span<warp::Pixel> pixels) const noexcept = 0;
};

struct Profile {
  std::string name;                                   ///< its description, or what it is if it has none
  std::string problem;                                ///< why it cannot be applied; empty: it can
  bool is_srgb = false;                               ///< its values are those of sRGB, within rounding
  std::shared_ptr<const ProfileTransform> transform;  ///< null if it is sRGB or cannot be applied
};

/// @param colors  colour channels of the picture: 1 gray, 3 RGB, 4 CMYK. A picture of gray may have an RGB profile.
Profile read_profile(std::span<const std::uint8_t> icc, int colors);

}  // namespace morphkit::media
