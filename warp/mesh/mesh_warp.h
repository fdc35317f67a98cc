#pragma once
// The two-pass mesh warp: Smythe, "A Two-Pass Mesh Warping Algorithm for Object Transformation and Image
// Interpolation", 1990; Wolberg, "Digital Image Warping", 1990, ch. 7.

#include <memory>
#include <span>

#include "warp/image/image.h"
#include "warp/mesh/mesh.h"
#include "warp/sample/sample.h"

namespace morphkit::warp {

namespace detail {
class MeshTables;
}

/// The curves through the vertices and along the scanlines.
enum class MeshSpline {
  kMonotone,    ///< cubic of Fritsch and Carlson: folds only if the vertices do
  kCatmullRom,  ///< the sources' choice; overshoots between uneven vertices
  kLinear       ///< straight
};

enum class PassOrder {
  kAuto,         ///< the order without folds; of two, the one that keeps more area
  kRowsFirst,    ///< pixels move along rows, then along columns
  kColumnsFirst  ///< the other way round
};

struct MeshWarpOptions {
  MeshSpline spline = MeshSpline::kMonotone;
  PassOrder order = PassOrder::kAuto;
};

/// The mesh of the intermediate image in `order` (not kAuto): x from one mesh, y from the other. It may fold although
/// neither end does: then a part turns by 90 degrees or more.
Mesh intermediate_mesh(const Mesh& from, const Mesh& to, PassOrder order);

/// The bottleneck of `order` (not kAuto): the part of the area, in [0, 1], that both ends have but the intermediate
/// image lacks. 0: the passes lose nothing. Over all cells: sum(max(0, need - has)) / sum(need). `need` is the smaller
/// of a cell's areas in `from` and `to`; `has` is its signed area in the intermediate mesh. Cost: O(vertices).
double area_lost(const Mesh& from, const Mesh& to, PassOrder order);

/// Bends an image from one mesh onto another.
class MeshWarp {
 public:
  /// @param from  in pixels of the source image, outline: the whole image.
  /// @param to    in pixels of the output; any outline. Same columns and rows as `from`.
  /// Meshes that fold are accepted: folded parts shrink to nothing, they are never drawn mirrored.
  /// @throws std::invalid_argument if the grids differ or are too small, if border vertices are not on an upright
  /// rectangle, or if coordinates are not finite or beyond 1e12.
  MeshWarp(Mesh from, Mesh to, const MeshWarpOptions& options = {});

  const Mesh& from() const noexcept;
  const Mesh& to() const noexcept;
  PassOrder order() const noexcept;  ///< the order in use, never kAuto

  /// @param source  linear, premultiplied RGBA; has the size of the outline of `from`.
  /// @param border  kTransparent: transparent outside the outline of `to`, antialiased; kClamp: the edge continues.
  /// @return        image of `size`.
  /// @throws std::invalid_argument if `source` is empty or differs in size from the outline of `from`, or if `border`
  /// is kMirror.
  /// Accuracy: every output pixel is the mean over its interval of the line. The running sum of a line is interpolated
  /// by a cubic, so magnified pixels blend smoothly, lines that do not move stay the same bit for bit, and constants
  /// stay constant. Alpha is clamped to [0, 1]. Cost: O(source + output) pixels for any warp, parallel over lines;
  /// memory: one intermediate image. See tests/bench/mesh_bench.cpp.
  Image apply(const Image& source, cv::Size size, Border border = Border::kTransparent) const;

  /// The two halves of `apply`. The image between them has output width x source height for kRowsFirst, else source
  /// width x output height.
  Image first_pass(const Image& source, cv::Size size, Border border = Border::kTransparent) const;
  Image second_pass(const Image& between, cv::Size size, Border border = Border::kTransparent) const;

  /// The source position of an output position, source px: the exact map of the two passes; NaN outside the outline.
  /// (Where kCatmullRom curves overshoot along a line, this map turns back; `apply` draws that part with no width.)
  /// Cost: O(columns + rows).
  cv::Point2d source_of(cv::Point2d output) const;

  /// source_of of every pixel centre. Parallel over rows. Memory: the map, and the knots of every column of pixels.
  Map map(cv::Size size) const;

 private:
  std::shared_ptr<const detail::MeshTables> tables_;
};

/// Interpolates one number per vertex over the output: linear along the columns of the mesh, then linear along each row
/// of pixels. Beyond the outline, the nearest value.
class MeshValues {
 public:
  /// @param values  one per vertex, row by row.
  MeshValues(const Mesh& mesh, std::span<const double> values);

  /// At the centres of the pixels (i, y), i in [0, out.size()). Thread-safe.
  void row(int y, std::span<float> out) const;

 private:
  Mesh mesh_;
  std::vector<double> values_;
};

}  // namespace morphkit::warp
