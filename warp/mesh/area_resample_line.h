#pragma once
// Which pixels are drawn, and which part of the source each covers; shared by the reference and the kernel of
// resample_line. Internal.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "warp/mesh/area_resample.h"

namespace morphkit::warp {

inline constexpr double kShortestIntervalPx = 1e-3;

/// A stretch of the source, never empty: from `begin` in [0, 1) of pixel `first` to `end` in (0, 1] of pixel `last`.
struct Interval {
  std::ptrdiff_t first, last;
  double begin, end;

  bool is_pixel() const { return first == last && begin == 0 && end == 1; }
  double length() const { return static_cast<double>(last - first) + (end - begin); }
};

/// [a, b] within the source, widened about its centre if it is too short.
inline Interval interval_of(double a, double b, std::size_t source_pixels) {
  if (b - a < kShortestIntervalPx) {
    const double centred = (a + b) / 2 - kShortestIntervalPx / 2;
    a = std::clamp(centred, 0.0, static_cast<double>(source_pixels) - kShortestIntervalPx);
    b = a + kShortestIntervalPx;
  }
  const double first = std::floor(a);
  const double last = std::ceil(b) - 1;
  return {static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(last), a - first, b - last};
}

/// The output pixels that [line.begin, line.end] touches: [.first, .second).
inline std::pair<std::size_t, std::size_t> covered_pixels(const LineEdges& line, std::size_t out_pixels) {
  const double size = static_cast<double>(out_pixels);
  const double begin = std::clamp(line.begin, 0.0, size);
  const double end = std::clamp(line.end, 0.0, size);
  if (!(begin < end)) return {0, 0};
  return {static_cast<std::size_t>(std::floor(begin)), static_cast<std::size_t>(std::ceil(end))};
}

/// The part of output pixel k that is covered.
inline double coverage(const LineEdges& line, std::size_t k) {
  const double left = static_cast<double>(k);
  return std::clamp(line.end - left, 0.0, 1.0) - std::clamp(line.begin - left, 0.0, 1.0);
}

}  // namespace morphkit::warp
