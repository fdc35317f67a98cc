#pragma once
// Curves through points in the plane. Travel along them: morph/motion/arc_length.h.

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
  /// @throws std::invalid_argument with the text of `problem` if the points do not make a curve.
  Curve(CurveKind kind, std::vector<cv::Point2d> points, bool closed);

  /// Why these points make no curve of this kind (too few, wrong number, not finite, beyond 1e12, zero length); nullopt
  /// if they do.
  static std::optional<std::string> problem(CurveKind kind, const std::vector<cv::Point2d>& points, bool closed);

  int segments() const noexcept { return static_cast<int>(bezier_.size() / 3); }
  bool closed() const noexcept { return closed_; }

  /// The point at u, which is clamped to [0, segments()]; at whole u exactly the point on the curve.
  cv::Point2d at(double u) const;
  /// dQ/du; at a joint, of the segment that begins there. Zero at a cusp and on a segment without length.
  cv::Point2d derivative(double u) const;

 private:
  std::vector<cv::Point2d> bezier_;  ///< 3 * segments + 1 control points
  bool closed_ = false;
};

/// n + 1 points along the curve at equal arc length, from its start to its end (for a closed curve the last equals the
/// first). n >= 1.
std::vector<cv::Point2d> equal_arc_points(const Curve& curve, int n);

/// The smallest number of chords, in [1, limit], for which every point of the curve is within `tolerance_px` (> 0) of
/// the equal-arc chord that spans it; `limit` if no number does. Closed: at least 3. A larger number may be worse: it
/// may cut a corner that a smaller one meets. A polyline with corners at uneven lengths needs many chords. Cost:
/// O(limit^2) point-to-chord distances at worst.
int chords_needed(const Curve& curve, double tolerance_px, int limit);

}  // namespace morphkit::motion
