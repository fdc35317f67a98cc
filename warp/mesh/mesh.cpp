#include "warp/mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace morphkit::warp {
namespace {

/// Whether the vertex is on its side of the outline, within `tolerance`; always true for inner vertices.
bool on_outline(const Mesh& mesh, int column, int row, const cv::Rect2d& outline, double tolerance) {
  const cv::Point2d at = mesh.at(column, row);
  const auto near = [&](double value, double side) { return std::abs(value - side) <= tolerance; };
  return (column != 0 || near(at.x, outline.x)) &&
         (column != mesh.columns - 1 || near(at.x, outline.x + outline.width)) && (row != 0 || near(at.y, outline.y)) &&
         (row != mesh.rows - 1 || near(at.y, outline.y + outline.height));
}

/// The polyline through a column as x of y, evaluated at rising y.
class ColumnWalk {
 public:
  ColumnWalk(const Mesh& mesh, int column) : mesh_(mesh), column_(column) {}

  double x_at(double y) {
    while (row_ + 2 < mesh_.rows && mesh_.at(column_, row_ + 1).y < y) ++row_;
    const cv::Point2d a = mesh_.at(column_, row_), b = mesh_.at(column_, row_ + 1);
    if (!(b.y > a.y)) return a.x;
    return std::lerp(a.x, b.x, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0));
  }

 private:
  const Mesh& mesh_;
  int column_, row_ = 0;
};

/// Calls broken(column, row, kind) for every vertex out of order along the rows of `mesh`: kind 0 against the left
/// neighbour, 1 across the column on the left, 2 across the column on the right.
template <typename Broken>
void check_columns(const Mesh& mesh, const Broken& broken) {
  for (int column = 0; column < mesh.columns; ++column) {
    ColumnWalk left(mesh, std::max(column - 1, 0)), right(mesh, std::min(column + 1, mesh.columns - 1));
    for (int row = 0; row < mesh.rows; ++row) {
      const cv::Point2d at = mesh.at(column, row);
      if (column > 0 && !(at.x > mesh.at(column - 1, row).x)) broken(column, row, 0);
      if (column > 0 && !(at.x > left.x_at(at.y))) broken(column, row, 1);
      if (column + 1 < mesh.columns && !(at.x < right.x_at(at.y))) broken(column, row, 2);
    }
  }
}

}  // namespace

Mesh uniform_mesh(int columns, int rows, const cv::Rect2d& outline) {
  Mesh mesh{columns, rows, {}};
  mesh.vertices.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.vertices.emplace_back(outline.x + outline.width * column / (columns - 1),
                                 outline.y + outline.height * row / (rows - 1));
  snap_to_outline(mesh, outline);
  return mesh;
}

Mesh transposed(const Mesh& mesh) {
  Mesh result{mesh.rows, mesh.columns, {}};
  result.vertices.reserve(mesh.vertices.size());
  for (int column = 0; column < mesh.columns; ++column)
    for (int row = 0; row < mesh.rows; ++row)
      result.vertices.emplace_back(mesh.at(column, row).y, mesh.at(column, row).x);
  return result;
}

std::optional<MeshVertex> off_outline(const Mesh& mesh, const cv::Rect2d& outline, double tolerance) {
  for (int row = 0; row < mesh.rows; ++row)
    for (int column = 0; column < mesh.columns; ++column)
      if (!on_outline(mesh, column, row, outline, tolerance)) return MeshVertex{column, row};
  return std::nullopt;
}

void snap_to_outline(Mesh& mesh, const cv::Rect2d& outline) {
  for (int column = 0; column < mesh.columns; ++column) {
    mesh.at(column, 0).y = outline.y;
    mesh.at(column, mesh.rows - 1).y = outline.y + outline.height;
  }
  for (int row = 0; row < mesh.rows; ++row) {
    mesh.at(0, row).x = outline.x;
    mesh.at(mesh.columns - 1, row).x = outline.x + outline.width;
  }
}

std::vector<MeshFold> find_folds(const Mesh& mesh) {
  std::vector<std::optional<MeshFoldKind>> kinds(mesh.vertices.size());
  const auto note = [&](int column, int row, MeshFoldKind kind) {
    std::optional<MeshFoldKind>& known = kinds[mesh.index(column, row)];
    known = known ? std::min(*known, kind) : kind;
  };
  using enum MeshFoldKind;
  check_columns(mesh, [&](int column, int row, int which) {
    note(column, row, which == 0 ? kLeftOfNeighbour : which == 1 ? kAcrossLeftCurve : kAcrossRightCurve);
  });
  check_columns(transposed(mesh), [&](int row, int column, int which) {
    note(column, row, which == 0 ? kAboveNeighbour : which == 1 ? kAcrossUpperCurve : kAcrossLowerCurve);
  });
  std::vector<MeshFold> folds;
  for (int row = 0; row < mesh.rows; ++row)
    for (int column = 0; column < mesh.columns; ++column)
      if (const auto kind = kinds[mesh.index(column, row)]) folds.push_back({{column, row}, *kind});
  std::stable_sort(folds.begin(), folds.end(), [](const MeshFold& a, const MeshFold& b) { return a.kind < b.kind; });
  return folds;
}

}  // namespace morphkit::warp
