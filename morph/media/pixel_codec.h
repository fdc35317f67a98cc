#pragma once
// Stored samples <-> linear, premultiplied float pixels. Knows transfer functions and alpha, but no files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::media {

enum class SampleType { kU8, kU16, kFloat };

std::size_t sample_bytes(SampleType type) noexcept;

/// How stored colour values become linear light.
struct Transfer {
  enum class Kind { kSrgb, kLinear, kGamma };
  Kind kind = Kind::kSrgb;
  float gamma = 1.0F;  ///< linear = stored ^ gamma, for kGamma
};

class ProfileTransform;

/// How stored colours become linear light with Rec.709 primaries.
struct ColorConversion {
  Transfer transfer;                                ///< unused with a profile
  std::shared_ptr<const ProfileTransform> profile;  ///< null: none
};

/// The factor in the stored colour.
enum class AlphaKind {
  kStraight,          ///< nothing
  kPremultiplied,     ///< alpha, in linear light (EXR)
  kStoredAssociated,  ///< alpha, after the transfer function (8- and 16-bit TIFF and TGA with associated alpha)
};

/// Pixels that could not be taken as they are stored.
struct PixelFaults {
  std::int64_t nonfinite = 0;      ///< a sample is NaN or infinite: transparent black instead
  std::int64_t alpha_outside = 0;  ///< alpha is clamped to [0, 1]
  std::int64_t above_alpha = 0;    ///< a premultiplied colour of an integer file is clamped to alpha

  PixelFaults& operator+=(const PixelFaults& other) noexcept;
  bool operator==(const PixelFaults&) const = default;
};

struct StoredLayout {
  SampleType type = SampleType::kU8;
  int channels = 4;         ///< samples from one pixel to the next
  int r = 0, g = 1, b = 2;  ///< index of each colour's sample; -1: the colour is 0
  int a = 3;                ///< -1: opaque
  int k = -1;               ///< black ink, if r, g and b are cyan, magenta and yellow; with a profile only
  ColorConversion color;
  AlphaKind alpha = AlphaKind::kStraight;
};

/// Reads rows of samples. Integer samples go through a table, made once per decoder.
class PixelDecoder {
 public:
  explicit PixelDecoder(const StoredLayout& layout);

  /// Alpha is in [0, 1] afterwards. Premultiplied floats may be brighter than alpha: fire and light in EXR. Integers
  /// cannot mean that, and division by a small alpha would make them burning specks.
  /// @param row  `width * layout.channels` samples.
  PixelFaults decode(const void* row, int width, warp::Pixel* out) const noexcept;

 private:
  template <typename Sample>
  PixelFaults decode_samples(const Sample* row, int width, warp::Pixel* out) const noexcept;
  template <typename Sample>
  PixelFaults decode_profiled(const Sample* row, int width, warp::Pixel* out) const noexcept;
  template <typename Sample>
  PixelFaults decode_kind(const void* row, int width, warp::Pixel* out) const noexcept;
  float linear(float stored) const noexcept;

  StoredLayout layout_;
  std::vector<float> table_;
};

/// Writes rows of samples. Integers are sRGB, rounded to nearest: RGB (over black) or unpremultiplied RGBA. Floats stay
/// linear and premultiplied.
class PixelEncoder {
 public:
  PixelEncoder(SampleType type, int channels) : type_(type), channels_(channels) {}
  void encode(const warp::Pixel* pixels, int width, void* row) const noexcept;

 private:
  SampleType type_;
  int channels_;
};

}  // namespace morphkit::media
