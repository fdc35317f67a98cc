#include "morph/exchange/fit_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace morphkit::exchange {
namespace {

constexpr double kRounding = 0.05;  // px: what the file formats round away
constexpr double kCentre = 0.5;     // px: where the other tools' border lies, the centre of the first pixel
constexpr double kLeastCell = 1;    // px: between the border and a mesh that covers only a part

struct Edges {
  bool left = false, right = false, top = false, bottom = false;

  bool any() const noexcept { return left || right || top || bottom; }
  int columns() const noexcept { return int{left} + int{right}; }
  int rows() const noexcept { return int{top} + int{bottom}; }
};

/// The largest distance of the vertices of each edge from the centres of the outermost pixels, px: left, right, top,
/// bottom.
std::array<double, 4> border_distances(const warp::Mesh& mesh, cv::Size size) {
  std::array<double, 4> distance{};
  const auto look = [&](std::size_t edge, double at, double wanted) {
    distance[edge] = std::max(distance[edge], std::abs(at - wanted));
  };
  for (int row = 0; row < mesh.rows; ++row) {
    look(0, mesh.at(0, row).x, kCentre);
    look(1, mesh.at(mesh.columns - 1, row).x, size.width - kCentre);
  }
  for (int column = 0; column < mesh.columns; ++column) {
    look(2, mesh.at(column, 0).y, kCentre);
    look(3, mesh.at(column, mesh.rows - 1).y, size.height - kCentre);
  }
  return distance;
}

/// The mesh with another row or column at these edges, on the border of the picture.
warp::Mesh with_margin(const warp::Mesh& inner, cv::Size size, const Edges& edges) {
  const auto cell = [](double extent, int vertices) { return std::min(kLeastCell, extent / (2 * vertices)); };
  const double x = cell(size.width, inner.columns), y = cell(size.height, inner.rows);
  const cv::Point2d least(edges.left ? x : 0, edges.top ? y : 0);
  const cv::Point2d most(size.width - (edges.right ? x : 0), size.height - (edges.bottom ? y : 0));
  warp::Mesh mesh{inner.columns + edges.columns(), inner.rows + edges.rows(), {}};
  mesh.vertices.reserve(static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows));
  for (int row = 0; row < mesh.rows; ++row) {
    for (int column = 0; column < mesh.columns; ++column) {
      const int from_column = std::clamp(column - int{edges.left}, 0, inner.columns - 1);
      const int from_row = std::clamp(row - int{edges.top}, 0, inner.rows - 1);
      const cv::Point2d& vertex = inner.at(from_column, from_row);
      mesh.vertices.emplace_back(std::clamp(vertex.x, least.x, most.x), std::clamp(vertex.y, least.y, most.y));
    }
  }
  return mesh;
}

std::string edge_names(const Edges& edges) {
  std::string names;
  const auto add = [&](bool there, const char* name) {
    if (there) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add(edges.left, "left");
  add(edges.right, "right");
  add(edges.top, "top");
  add(edges.bottom, "bottom");
  return names;
}

/// The middle of a vertex's neighbours; along the border only of those on the border, so it stays there.
cv::Point2d middle_of_neighbours(const warp::Mesh& mesh, int column, int row) {
  const bool side = column == 0 || column == mesh.columns - 1, end = row == 0 || row == mesh.rows - 1;
  if (side && end) return mesh.at(column, row);
  if (end) return (mesh.at(column - 1, row) + mesh.at(column + 1, row)) / 2;
  if (side) return (mesh.at(column, row - 1) + mesh.at(column, row + 1)) / 2;
  return (mesh.at(column - 1, row) + mesh.at(column + 1, row) + mesh.at(column, row - 1) + mesh.at(column, row + 1)) /
         4;
}

/// Moves the vertices that are out of order by small steps; later their neighbours too, which may be in their way.
/// @return whether none is left.
bool relax_folds(warp::Mesh& mesh) {
  constexpr int kRounds = 400, kRoundsAlone = 100;
  constexpr double kStep = 0.1;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<warp::MeshFold> folds = warp::find_folds(mesh);
    if (folds.empty()) return true;
    const int reach = round < kRoundsAlone ? 0 : 1;
    const warp::Mesh before = mesh;
    for (const warp::MeshFold& fold : folds) {
      for (int row = std::max(fold.vertex.row - reach, 0); row <= std::min(fold.vertex.row + reach, mesh.rows - 1);
           ++row)
        for (int column = std::max(fold.vertex.column - reach, 0);
             column <= std::min(fold.vertex.column + reach, mesh.columns - 1); ++column) {
          const cv::Point2d from = before.at(column, row);
          mesh.at(column, row) = from + kStep * (middle_of_neighbours(before, column, row) - from);
        }
    }
  }
  return false;
}

/// Between the mesh and an even one, as near to the mesh as the order allows.
void blend_with_even(warp::Mesh& mesh, cv::Size size) {
  constexpr int kHalvings = 20;
  const warp::Mesh even = warp::uniform_mesh(mesh.columns, mesh.rows, {{0, 0}, cv::Size2d(size)});
  const auto blend = [&](double share) {
    warp::Mesh result = mesh;
    for (std::size_t i = 0; i < result.vertices.size(); ++i)
      result.vertices[i] += share * (even.vertices[i] - result.vertices[i]);
    return result;
  };
  double folded = 0, ordered = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double share = (folded + ordered) / 2;
    (warp::find_folds(blend(share)).empty() ? ordered : folded) = share;
  }
  mesh = blend(ordered);
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(size)});
}

}  // namespace

void fit_to_pictures(std::span<PictureMesh> meshes, std::vector<std::string>& remarks) {
  Edges apart;
  for (const PictureMesh& one : meshes) {
    const std::array<double, 4> distance = border_distances(one.mesh, one.size);
    apart.left |= distance[0] > kBorderSlipPx;
    apart.right |= distance[1] > kBorderSlipPx;
    apart.top |= distance[2] > kBorderSlipPx;
    apart.bottom |= distance[3] > kBorderSlipPx;
  }
  for (PictureMesh& one : meshes) {
    const std::array<double, 4> distances = border_distances(one.mesh, one.size);
    if (apart.any()) {
      one.mesh = with_margin(one.mesh, one.size, apart);
      remarks.push_back(fmt::format("{}: covers a part of the picture; vertices on the border were added ({})",
                                    one.name, edge_names(apart)));
    }
    const double slips[] = {apart.left ? 0 : distances[0], apart.right ? 0 : distances[1], apart.top ? 0 : distances[2],
                            apart.bottom ? 0 : distances[3]};
    if (const double distance = std::ranges::max(slips); distance > kRounding) {
      remarks.push_back(
          fmt::format("{}: vertices of the border were up to {:.1f} pixels off and moved onto it", one.name, distance));
    }
    warp::snap_to_outline(one.mesh, {{0, 0}, cv::Size2d(one.size)});
  }
}

void unfold(PictureMesh& mesh, std::vector<std::string>& remarks) {
  if (warp::find_folds(mesh.mesh).empty()) return;
  const warp::Mesh before = mesh.mesh;
  if (!relax_folds(mesh.mesh)) {
    mesh.mesh = before;
    blend_with_even(mesh.mesh, mesh.size);
  }
  int moved = 0;
  double most = 0;
  for (std::size_t i = 0; i < before.vertices.size(); ++i) {
    const double distance = cv::norm(mesh.mesh.vertices[i] - before.vertices[i]);
    if (distance > 0) ++moved;
    most = std::max(most, distance);
  }
  remarks.push_back(
      fmt::format("{}: folded over; {} vertices were moved by up to {:.1f} pixels", mesh.name, moved, most));
}

}  // namespace morphkit::exchange
