#pragma once
// The curves of a mesh, and the map along a scanline that crosses the curves. Internal to warp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "warp/mesh/mesh_warp.h"

namespace morphkit::warp {

/// Slopes of the curve y(x) at its knots. @pre x never falls; equal neighbours count as flat.
void spline_slopes(MeshSpline spline, std::span<const double> x, std::span<const double> y, std::span<double> slopes);

/// No segment known yet: use binary search.
inline constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

/// All curves of a mesh in one direction. The vertical ones give x ("across") as a function of y ("along").
class CurveFamily {
 public:
  /// @param along, across  the knots, curve by curve; `along` is made to rise.
  CurveFamily(MeshSpline spline, std::size_t knots, std::vector<double> along, std::vector<double> across);

  std::size_t curves() const noexcept { return across_.size() / knots_; }

  /// The last segment found in each curve, where the next search begins; or kUnknown.
  using Hints = std::vector<std::size_t>;

  /// `across` of every curve at one coordinate. Rising if the polylines are in order there and the spline is monotone.
  void intercepts(double at, Hints& hints, std::span<double> across) const;

  /// The same for one curve. It depends on its two neighbours only.
  double intercept(std::size_t curve, double at, Hints& hints) const;

 private:
  struct Place;

  Place place(std::size_t curve, double at, Hints& hints) const;
  double linear(const Place& place) const;
  double cubic(const Place& place) const;
  double ordered(double linear, double cubic, double gap_before, double gap_after) const;

  MeshSpline spline_;
  std::size_t knots_;
  std::vector<double> along_, across_, slopes_;  ///< curve by curve
};

/// The knots of a scanline: places on the output line and their places on the source line.
struct LineKnots {
  std::vector<double> to, from;  ///< never falling
  std::vector<double> slopes;    ///< of from(to)
  MeshSpline spline = MeshSpline::kMonotone;

  void resize(std::size_t count);
  /// Clamps `from` to [0, most], makes both rise by a running maximum, and computes the slopes.
  void prepare(MeshSpline kind, double most);
  /// `from` at x. Outside the knots, the value of the nearest knot. @param segment  where the search begins (or
  /// kUnknown); receives the segment of x.
  double at(double x, std::size_t& segment) const;
  /// `from` at x = 0, 1, ..., edges.size() - 1.
  void edges(std::span<double> edges);

  /// On the segment after a knot, from - x is a cubic of the fraction u of the segment: exact where nothing moves.
  struct Cubic {
    double inverse_width = 0, c0 = 0, c1 = 0, c2 = 0, c3 = 0;
  };

 private:
  Cubic cubic(std::size_t segment) const;

  std::vector<Cubic> cubics_;  ///< of `edges`, kept to reuse the memory
};

/// The inner loop of LineKnots::edges: the map at the whole numbers k with to.front() <= k < to.back(), into edges[k].
/// Other entries may be overwritten with any values. Class E: the same bits on every instruction set.
/// @param cubics  one per segment.
void fill_edges(const LineKnots& knots, std::span<const LineKnots::Cubic> cubics, std::span<double> edges) noexcept;

/// The first whole number at or after x, clamped to [0, most].
inline std::size_t whole_from(double x, std::size_t most) {
  return static_cast<std::size_t>(std::clamp(std::ceil(x), 0.0, static_cast<double>(most)));
}

/// One pass: both families cross the same scanlines.
struct MeshPass {
  MeshSpline spline;
  CurveFamily to, from;

  struct Hints {
    CurveFamily::Hints to, from;
  };
  Hints hints() const;

  /// Knots of the scanline at coordinate `along`. @param most  length of the source line.
  void knots(double along, double most, Hints& hints, LineKnots& knots) const;

  /// The map along the scanline at `along`, in one place, from the few curves around it. Equal to knots() followed by
  /// at() unless the mesh folds. @param segment  as LineKnots::at.
  double at(double along, double x, double most, Hints& hints, std::size_t& segment) const;
};

}  // namespace morphkit::warp
