#pragma once
// A grid of vertices over an image, and the places where such a grid folds.

#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core/types.hpp>

namespace morphkit::warp {

/// Vertices row by row. A mesh that warps has its border vertices on the sides of an upright rectangle, its outline,
/// and its corners at the corners.
struct Mesh {
  int columns = 0;                    ///< vertices in a row, >= 2
  int rows = 0;                       ///< vertices in a column, >= 2
  std::vector<cv::Point2d> vertices;  ///< columns * rows; every function of a mesh relies on all three

  const cv::Point2d& at(int column, int row) const { return vertices[index(column, row)]; }
  cv::Point2d& at(int column, int row) { return vertices[index(column, row)]; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  bool operator==(const Mesh&) const = default;
};

/// Evenly spaced over `outline`; the border lies on it exactly.
Mesh uniform_mesh(int columns, int rows, const cv::Rect2d& outline);

/// Rows become columns, x becomes y.
Mesh transposed(const Mesh& mesh);

/// A vertex in a wrong place.
struct MeshVertex {
  int column = 0, row = 0;
  bool operator==(const MeshVertex&) const = default;
};

/// The first border vertex that is farther than `tolerance` px from its side of `outline` (a corner: from its corner),
/// row by row.
std::optional<MeshVertex> off_outline(const Mesh& mesh, const cv::Rect2d& outline, double tolerance);

/// Moves the border vertices onto `outline`; the inner ones stay.
void snap_to_outline(Mesh& mesh, const cv::Rect2d& outline);

/// How a vertex violates the order of its mesh.
enum class MeshFoldKind {
  kLeftOfNeighbour,   ///< not right of its left neighbour in the row
  kAboveNeighbour,    ///< not below its upper neighbour in the column
  kAcrossLeftCurve,   ///< not right of the line through the column on its left, at its own height
  kAcrossRightCurve,  ///< not left of the line through the column on its right
  kAcrossUpperCurve,  ///< not below the line through the row above it
  kAcrossLowerCurve   ///< not above the line through the row below it
};

struct MeshFold {
  MeshVertex vertex;
  MeshFoldKind kind = MeshFoldKind::kLeftOfNeighbour;
};

/// Every vertex that is out of order, once, with the first kind that applies. Sorted by kind, then row by row. Without
/// folds, the polylines through the columns are functions of y that keep their order at every height, and those through
/// the rows are such functions of x, as two passes need. Cost: O(vertices).
std::vector<MeshFold> find_folds(const Mesh& mesh);

}  // namespace morphkit::warp
