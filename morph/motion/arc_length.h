#pragma once
// Travel along a curve at constant speed.

#include <vector>

#include "morph/motion/curve.h"

namespace morphkit::motion {

/// Arc length along a curve and its inverse: an adaptive table of (u, s), refined until both halves of each piece agree
/// with the whole (Guenter & Parent 1990; Parent 3.2.1). Holds a copy of the curve.
class ArcLength {
 public:
  struct Node {
    double u, s;
  };

  /// @param tolerance  absolute error of the total length, same unit as the points; > 0. Not kept below 1e-13 of the
  ///                   length of the control polygon, where rounding dominates.
  explicit ArcLength(Curve curve, double tolerance = 1e-6);

  double total() const noexcept { return table_.back().s; }
  /// s in [0, total()], rising with u; u is clamped. Cost: O(log table) + five evaluations of the curve.
  double length_at(double u) const;
  /// u with length_at(u) = s, s clamped; bracketed Newton, bisection where |Q'| is near 0.
  double parameter_at(double s) const;

  const Curve& curve() const noexcept { return curve_; }
  /// From (0, 0) to (segments, total). Holds every joint; dense where the speed |Q'| changes fast, as at cusps.
  const std::vector<Node>& table() const noexcept { return table_; }

 private:
  Curve curve_;
  std::vector<Node> table_;
};

}  // namespace morphkit::motion
