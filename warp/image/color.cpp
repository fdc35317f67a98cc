#include "warp/image/color.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace morphkit::warp {
namespace {

constexpr double kSlope = 12.92;
constexpr double kOffset = 0.055;
constexpr double kGamma = 2.4;
/// Where the straight piece and the power curve meet.
constexpr double kBreakLinear = 0.00313066844250060;
constexpr double kBreakSrgb = kSlope * kBreakLinear;

struct Jet {
  double value;
  double slope;
};

Jet decode_curve(double srgb) {
  const double base = (srgb + kOffset) / (1 + kOffset);
  return {std::pow(base, kGamma), kGamma * std::pow(base, kGamma - 1) / (1 + kOffset)};
}

Jet encode_curve(double linear) {
  const double power = std::pow(linear, 1 / kGamma);
  return {(1 + kOffset) * power - kOffset, (1 + kOffset) * power / (kGamma * linear)};
}

/// A smooth curve as cubic Hermite pieces, 32 per octave, on [2^kFirstExponent, 2^kEndExponent). With exact values and
/// slopes at the knots the error is |f''''| h^4 / 384 < 2.6e-9 relative for the curves here, far below half an ulp of
/// float; the pieces join, so the curve stays monotone after the double result is rounded.
template <int kFirstExponent, int kEndExponent>
class CurveTable {
 public:
  explicit CurveTable(Jet (*curve)(double)) {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const double begin = std::bit_cast<float>(kFirstBits + (i << kShift));
      const double end = std::bit_cast<float>(kFirstBits + ((i + 1) << kShift));
      const double width = end - begin;
      const Jet left = curve(begin);
      const Jet right = curve(end);
      const double secant = (right.value - left.value) / width;
      pieces_[i] = {left.value, left.slope, (3 * secant - 2 * left.slope - right.slope) / width,
                    (left.slope + right.slope - 2 * secant) / (width * width)};
    }
  }

  /// @param x  at least 2^kFirstExponent, not NaN.
  float operator()(float x, Jet (*curve)(double)) const noexcept {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t index = (bits - kFirstBits) >> kShift;
    if (index >= pieces_.size()) [[unlikely]] {
      return static_cast<float>(curve(x).value);
    }
    const std::array<double, 4>& c = pieces_[index];
    const double d = static_cast<double>(x) - static_cast<double>(std::bit_cast<float>(bits & kKnotMask));
    return static_cast<float>(c[0] + d * (c[1] + d * (c[2] + d * c[3])));
  }

 private:
  static constexpr int kMantissaBits = 23;
  static constexpr int kPieceBits = 5;
  static constexpr int kShift = kMantissaBits - kPieceBits;
  static constexpr std::uint32_t kKnotMask = ~((1U << kShift) - 1);
  static constexpr std::uint32_t kFirstBits = static_cast<std::uint32_t>(127 + kFirstExponent) << kMantissaBits;
  static constexpr std::size_t kPieces = static_cast<std::size_t>(kEndExponent - kFirstExponent) << kPieceBits;

  std::array<std::array<double, 4>, kPieces> pieces_;
};

/// From below the break (2^-5 < 0.0404, 2^-9 < 0.0031) to 16; brighter values are rare and take std::pow.
using DecodeTable = CurveTable<-5, 4>;
using EncodeTable = CurveTable<-9, 4>;

const DecodeTable& decode_table() noexcept {
  static const DecodeTable table(decode_curve);
  return table;
}

const EncodeTable& encode_table() noexcept {
  static const EncodeTable table(encode_curve);
  return table;
}

inline float decode(const DecodeTable& table, float value) noexcept {
  const float magnitude = std::fabs(value);
  // The comparison is negated so that NaN takes the straight piece and stays NaN.
  if (!(magnitude > static_cast<float>(kBreakSrgb))) return static_cast<float>(value / kSlope);
  return std::copysign(table(magnitude, decode_curve), value);
}

inline float encode(const EncodeTable& table, float value) noexcept {
  const float magnitude = std::fabs(value);
  if (!(magnitude > static_cast<float>(kBreakLinear))) return static_cast<float>(value * kSlope);
  return std::copysign(table(magnitude, encode_curve), value);
}

}  // namespace

float linear_from_srgb(float value) noexcept {
  return decode(decode_table(), value);
}

float srgb_from_linear(float value) noexcept {
  return encode(encode_table(), value);
}

void linear_from_srgb(std::span<float> values) noexcept {
  const DecodeTable& table = decode_table();
  for (float& value : values) value = decode(table, value);
}

void srgb_from_linear(std::span<float> values) noexcept {
  const EncodeTable& table = encode_table();
  for (float& value : values) value = encode(table, value);
}

}  // namespace morphkit::warp
