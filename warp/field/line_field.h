#pragma once
// The feature-line field of Beier and Neely, "Feature-Based Image Metamorphosis", SIGGRAPH 1992.

#include <memory>
#include <span>
#include <vector>

#include "warp/image/image.h"

namespace morphkit::warp {

namespace detail {
class FieldTables;
}

/// A directed line from p to q. A line with p = q is a point.
struct Line {
  cv::Point2d p, q;
};

/// How strongly a line pulls: w = (length^p / (a + distance))^b.
struct LineWeight {
  double a = 1;  ///< px, [0, 1e9]; 0: pixels on the line follow it exactly
  double b = 2;  ///< [0, 8]; how fast the pull falls with distance
  double p = 0;  ///< [0, 1]; how much longer lines pull more
  /// [1e-6, 1e6]; one output pixel counts as `unit` px in `a`, lengths and distances.
  /// It is 1 except for a reduced or magnified view of another frame: then `a` is in px of that frame, and the weights
  /// are the same as there.
  double unit = 1;
};

/// How distances from a line scale between the two sides.
enum class LineScale {
  kAlong,   ///< stretch along the line only; distances across stay (the paper)
  kUniform  ///< a similarity: distances across scale with the line's length (Parent 3.8.2)
};

/// One feature line of the output frame and where it lies in every target image.
struct FieldLine {
  Line output;                ///< output frame
  std::vector<Line> targets;  ///< one per target, target frame
  LineWeight weight;
  LineScale scale = LineScale::kAlong;
  double value = 0;  ///< any scalar that belongs to the feature; spread by the same weights
};

enum class FieldAccuracy {
  kExact,    ///< every line at every pixel
  kAdaptive  ///< lines whose weights are smooth over a tile are interpolated
};

/// Side of the square tiles in which the field is evaluated, px. Tiles begin at multiples of it.
inline constexpr int kFieldTile = 32;

/// For an output pixel centre X, X_target = X + sum(w (X' - X)) / sum(w), with X' the image of X under each pair. The
/// weights depend on the output lines only, so one pass serves any number of targets.
class LineField {
 public:
  /// @param lines    finite coordinates within 1e9 px of the origin; values within the range of a float; every line has
  ///                 `targets` targets. If a line is a point in the output or in a target (also while it turns through
  ///                 length 0), the displacement of its midpoint is used.
  /// @param targets  number of targets, >= 1.
  /// @throws std::invalid_argument on a broken contract, naming the line.
  LineField(std::span<const FieldLine> lines, int targets);

  int targets() const noexcept;
  bool empty() const noexcept;  ///< no lines: the identity

  /// Target positions of the pixel centres of `area`, a part of the output frame anywhere within 2^30 px.
  /// @param positions  one map of the size of `area` per target; the maps are written in place.
  /// @param values     weighted mean of the lines' values, same size; null if not wanted. 0 without lines.
  /// @throws std::invalid_argument on the wrong number or size of maps.
  /// Accuracy: class T, within kFieldTolerancePx (kExact) or kAdaptiveTolerancePx (kAdaptive) of `reference` wherever
  /// |position| < 2^15 px (2^16 px) and equal to it everywhere else. Pixels on a line with a = 0, and pixels with too
  /// large a bound on their float error, are taken from the reference. The result for a pixel does not depend on the
  /// requested area. Thread-safe.
  /// Cost: whole tiles of kFieldTile, so areas should be multiples of that; kExact O(pixels x lines); kAdaptive
  /// O(pixels x lines near them + tiles x lines); see tests/bench/field_bench.cpp.
  void evaluate(cv::Rect area, FieldAccuracy accuracy, std::span<Map> positions, cv::Mat1f* values = nullptr) const;

  /// The specification: the same in plain scalar double arithmetic.
  void reference(cv::Rect area, std::span<Map> positions, cv::Mat1f* values = nullptr) const;

 private:
  std::shared_ptr<const detail::FieldTables> tables_;
};

/// Bounds on the distance from the reference, px.
inline constexpr double kFieldTolerancePx = 0.004;
inline constexpr double kAdaptiveTolerancePx = 1.0 / 32;

}  // namespace morphkit::warp
