#include "warp/mesh/area_resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "warp/mesh/area_resample_line.h"

namespace morphkit::warp {
namespace {

/// The source with its edge pixels repeated beyond the ends, and the integral of its reconstruction. The running sum F
/// at pixel edges is interpolated by Catmull-Rom: with the slope m_j = (p_{j-1} + p_j) / 2 at edge j, the integral over
/// pixel j from its left edge is a cubic in the position within the pixel. Conservative remapping of this kind:
/// Colella and Woodward, "The Piecewise Parabolic Method", J. Comput. Phys. 54 (1984), sec. 1.
class Integral {
 public:
  explicit Integral(std::span<const Pixel> source) : source_(source) {}

  double pixel(std::ptrdiff_t j, int channel) const {
    const auto last = static_cast<std::ptrdiff_t>(source_.size()) - 1;
    return static_cast<double>(source_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(j, 0, last))][channel]);
  }

  /// Over [j, j + u], u in [0, 1].
  double head(std::ptrdiff_t j, double u, int channel) const {
    const double at = pixel(j, channel);
    const double slope = (pixel(j - 1, channel) + at) / 2;
    const double next_slope = (at + pixel(j + 1, channel)) / 2;
    // The Hermite basis sums to u: in this form, a constant is integrated without error.
    return u * at + u * (1 - u) * (1 - u) * (slope - at) - u * u * (1 - u) * (next_slope - at);
  }

  double over(const Interval& interval, int channel) const {
    const auto [first, last, begin, end] = interval;
    if (first == last) return head(first, end, channel) - head(first, begin, channel);
    double sum = pixel(first, channel) - head(first, begin, channel);
    for (std::ptrdiff_t j = first + 1; j < last; ++j) sum += pixel(j, channel);
    return sum + head(last, end, channel);
  }

 private:
  std::span<const Pixel> source_;
};

/// Overshoot: alpha outside [0, 1] has no meaning and is clamped; colours outside have one. As in the bicubic sampler,
/// NaN becomes the lower bound.
float finish(double value, int channel) {
  constexpr double kMax = std::numeric_limits<float>::max();
  const double lower = channel == 3 ? 0 : -kMax;
  const double upper = channel == 3 ? 1 : kMax;
  return static_cast<float>(value > lower ? std::min(value, upper) : lower);
}

}  // namespace

void reference_resample_line(std::span<const Pixel> source, const LineEdges& line, std::span<Pixel> out) noexcept {
  assert(!source.empty());
  assert(line.edges.size() == out.size() + 1);
  const Integral integral(source);
  const auto [covered_begin, covered_end] = covered_pixels(line, out.size());
  std::fill(out.begin(), out.end(), Pixel::all(0));
  for (std::size_t k = covered_begin; k < covered_end; ++k) {
    const double a = line.edges[k];
    const double b = line.edges[k + 1];
    const Interval interval = interval_of(a, b, source.size());
    if (interval.is_pixel()) {
      out[k] = source[static_cast<std::size_t>(interval.first)];
    } else {
      for (int c = 0; c < 4; ++c) out[k][c] = finish(integral.over(interval, c) / interval.length(), c);
    }
    const double covered = coverage(line, k);
    if (covered < 1) out[k] *= static_cast<float>(covered);
  }
}

}  // namespace morphkit::warp
