#pragma once
// The antialiasing filters, one struct each. A new filter is a struct here, its kernel in filters-inl.h, and its name
// in AntialiasingFilters. Internal to warp/sample.

#include <cmath>
#include <numbers>

#include "warp/sample/sample.h"

namespace morphkit::warp::detail {

// Each filter has
//   kName         its name in the public interface.
//   kMostStretch  source px per output px at which a footprint stops growing.
//   kHasPoints    small areas are made of points (antialias.h).
//   kIsSlab the weight along an axis is a box filtered by the reconstruction kernel, so its width and reach depend on
//                 the footprint. Otherwise it is weight(u) within kReach output px.

/// The mean over the pixel's square.
struct AreaFilter {
  static constexpr Filter kName = Filter::kArea;
  static constexpr float kMostStretch = 16;
  static constexpr bool kHasPoints = true;
  static constexpr bool kIsSlab = true;
};

/// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988, eq. 8 with B = C = 1/3.
struct MitchellFilter {
  static constexpr Filter kName = Filter::kMitchell;
  static constexpr float kMostStretch = 8;
  static constexpr bool kHasPoints = false;
  static constexpr bool kIsSlab = false;
  static constexpr float kReach = 2;
  static double weight(double x) {
    const double a = std::abs(x);
    if (a < 1) return (7 * a * a * a - 12 * a * a + 16.0 / 3) / 6;
    if (a < 2) return (-7.0 / 3 * a * a * a + 12 * a * a - 20 * a + 32.0 / 3) / 6;
    return 0;
  }
};

/// sinc(x) sinc(x / 3).
struct LanczosFilter {
  static constexpr Filter kName = Filter::kLanczos;
  static constexpr float kMostStretch = 8;
  static constexpr bool kHasPoints = false;
  static constexpr bool kIsSlab = false;
  static constexpr float kReach = 3;
  static double weight(double x) { return std::abs(x) < 3 ? sinc(x) * sinc(x / 3) : 0; }

 private:
  static double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }
};

template <typename... Filters>
struct FilterSet {
  static constexpr bool contains(Filter name) { return ((Filters::kName == name) || ...); }
  /// Calls `fn` with the filter of that name. @pre contains(name).
  template <typename Fn>
  static void visit(Filter name, const Fn& fn) {
    const bool found = ((Filters::kName == name && (fn(Filters()), true)) || ...);
    static_cast<void>(found);
  }
};

using AntialiasingFilters = FilterSet<AreaFilter, MitchellFilter, LanczosFilter>;

}  // namespace morphkit::warp::detail
