#pragma once
// The lines of a LineField, laid out for the kernel. Internal to warp; tests may include it.

#include <algorithm>
#include <span>
#include <vector>

#include "warp/field/line_field.h"

namespace morphkit::warp::detail {

/// A pixel with a + distance below this lies on the line, and only lines that it lies on count for it. Small compared
/// to a pixel, but large enough that (a + distance)^-8 stays in the range of a float.
inline constexpr double kOnLinePx = 0x1p-14;

/// The range of all values counts as this many px when the accuracy of the value channel is bounded.
inline constexpr double kValueChannelRange = 32;

/// The falloff exponents for which the kernel needs no logarithm, and any other.
enum class WeightKind { kOne, kOneAndHalf, kTwo, kAny };
inline constexpr size_t kWeightKinds = 4;

/// Lines of one kind are stored together and start at a multiple of this, as does every chunk of the kernel.
inline constexpr int kLineChunk = 16;

/// Nodes of a tile in each direction. Sums of far lines are evaluated at the nodes and interpolated between them.
inline constexpr int kFieldNodes = 5;

/// Weights with a log2 below this count as 0.
inline constexpr double kLeastLog2 = -1e4;

/// Chebyshev nodes over a tile's pixel centres, as offsets from the middle pixel, and the Lagrange polynomials of the
/// nodes at every pixel centre: with `value[j]` at the nodes, the value at pixel k is sum(basis[j][k] value[j]).
struct NodeTable {
  float offset[kFieldNodes];
  alignas(64) float basis[kFieldNodes][kFieldTile];
};
const NodeTable& node_table();

struct LineGroup {
  WeightKind kind = WeightKind::kAny;
  int begin = 0;
  int count = 0;

  // As indices of arrays.
  size_t first() const { return static_cast<size_t>(begin); }
  size_t end() const { return static_cast<size_t>(begin) + static_cast<size_t>(count); }
  size_t padded_end() const { return (end() + kLineChunk - 1) / kLineChunk * kLineChunk; }
};

/// Lines as arrays, one entry per line, sorted by kind. Lines of weight 0 fill the gaps between groups.
///
/// A *channel* is a quantity that the weights average and that is affine in X for each line: the two coordinates of the
/// displacement for every target, then the value (scaled to [0, kValueChannelRange] over all lines).
class FieldTables {
 public:
  /// @throws std::invalid_argument as LineField's constructor.
  FieldTables(std::span<const FieldLine> lines, int targets);

  int targets() const { return targets_; }
  int channels() const { return 2 * targets_ + 1; }
  int value_channel() const { return 2 * targets_; }
  int lines() const { return lines_; }    ///< real ones
  int padded() const { return padded_; }  ///< with the gaps; a multiple of kLineChunk
  std::span<const LineGroup> groups() const { return groups_; }

  /// True if an exponent is above 2: weights may then leave the range of a float unless they are scaled for each tile.
  bool wide_range() const { return wide_range_; }

  double value_from_channel(double channel) const {
    return value_min_ + value_range_ * std::clamp(channel / kValueChannelRange, 0.0, 1.0);
  }

  const double* at(int channel) const { return &at_[static_cast<size_t>(channel) * padded_]; }  ///< at X = P
  const double* slope_x(int channel) const { return &slope_x_[static_cast<size_t>(channel) * padded_]; }
  const double* slope_y(int channel) const { return &slope_y_[static_cast<size_t>(channel) * padded_]; }

  // Geometry: P, unit vector from P to Q ((1, 0) for a point), length (0 for a point), px.
  std::vector<double> origin_x, origin_y, along_x, along_y, length;
  // Weight: (length^p / (a + distance))^b. `factor` is length^(p b) divided by the largest of all lines; 0 for padding.
  // A point counts as length 1.
  std::vector<double> a, b, factor, log2_factor;
  std::vector<double> root;  ///< factor^(1/b) for kinds other than kAny

  // The same as floats, where they are accurate enough. `power` is -b, `scale` log2_factor, at least kLeastLog2.
  std::vector<float> along_x_single, along_y_single, a_single, root_single, power_single, scale_single;
  std::vector<float> smooth_single;  ///< (b + 4 over 5): how the fifth derivative of a weight grows with b

 private:
  void reserve_places(std::span<const FieldLine> lines, std::vector<int>& place);
  void fill(const FieldLine& line, int place);
  void fill_target(const Line& output, const Line& target, LineScale scale, int channel, int place);
  void fill_values(std::span<const FieldLine> lines, std::span<const int> place);
  void normalise_factors(std::span<const int> place);
  void fill_singles();

  int targets_ = 0;
  int lines_ = 0;
  int padded_ = 0;
  bool wide_range_ = false;
  double value_min_ = 0;
  double value_range_ = 0;
  std::vector<LineGroup> groups_;
  std::vector<double> at_, slope_x_, slope_y_;
};

/// The specification for one pixel: weighted means of the chosen channels at output position (x, y). `means` has the
/// length of `channels`. Zero without lines.
void reference_point(const FieldTables& tables, double x, double y, std::span<const int> channels,
                     std::span<double> means) noexcept;

/// The Highway kernel behind LineField::evaluate; arguments as there, already checked.
/// @return the number of pixels taken from the reference.
int simd_evaluate(const FieldTables& tables, cv::Rect area, FieldAccuracy accuracy, std::span<Map> positions,
                  cv::Mat1f* values);

}  // namespace morphkit::warp::detail
