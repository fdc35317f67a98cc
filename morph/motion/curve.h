#pragma once
// Curves through points in the plane, and travel along them by arc length.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

namespace morphkit::motion {

enum class CurveKind {
  kPolyline,    ///< straight between points
  kCatmullRom,  ///< through all points; tangents normalised for uneven keys (Gascuel & Lyon 1995, eq. 3)
  kBezier       ///< cubic pieces: 3n + 1 points, every third one on the curve; closed: 3n points
};

/// A piecewise cubic curve Q(u), u in [0, segments()].
class Curve {
 public:
  /// @param closed  joins the last point to the first.
  /// @throws std::invalid_argument with the sentence of `problem` if the points do not make a curve.
  Curve(CurveKind kind, std::vector<cv::Point2d> points, bool closed);

  /// Why these points make no curve of this kind (too few, wrong number, not finite, zero length), or nothing.
  static std::optional<std::string> problem(CurveKind kind, const std::vector<cv::Point2d>& points, bool closed);

  int segments() const noexcept;
  cv::Point2d at(double u) const;
  cv::Point2d derivative(double u) const;

 private:
  std::vector<cv::Point2d> bezier_;  ///< 3 * segments + 1 control points
};

/// Arc length along a curve and its inverse: an adaptive table of (u, s), refined until halves agree with the whole
/// (Guenter & Parent 1990; Parent 3.2.1).
class ArcLength {
 public:
  /// @param tolerance  absolute error of the total length, same unit as the points.
  explicit ArcLength(const Curve& curve, double tolerance = 1e-6);

  double total() const noexcept;
  double length_at(double u) const;     ///< s in [0, total]
  double parameter_at(double s) const;  ///< u; bracketed Newton, bisection where |Q'| is near 0
};

/// n + 1 points along the curve at equal arc length, from its start to its end (for a closed curve the last equals the
/// first). n >= 1.
std::vector<cv::Point2d> equal_arc_points(const Curve& curve, int n);

/// The number of chords, in [1, limit], that keeps equal-arc chords within `tolerance_px` of the curve.
int chords_needed(const Curve& curve, double tolerance_px, int limit);

}  // namespace morphkit::motion
