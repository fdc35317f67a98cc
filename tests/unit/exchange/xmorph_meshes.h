#pragma once
// Meshes in xmorph's files.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "morph/exchange/import_xmorph.h"
#include "morph/project/project.h"

namespace morphkit::test {

/// 3 x 3 vertices on a picture of 101 x 51 pixels.
inline constexpr const char* kXmorphMesh =
    "M2\n3 3\n"
    "0 0 0\n480 0 0\n1000 0 0\n"
    "0 240 0\n515 263 -1\n1000 260 0\n"
    "0 500 0\n500 500 0\n1000 500 0\n";

inline warp::Mesh parsed(const std::string& text, cv::Size size, std::vector<std::string>* remarks = nullptr) {
  std::vector<std::string> ignored;
  return exchange::parse_xmorph_mesh(text, "a.mesh", size, remarks ? *remarks : ignored);
}

inline double largest_distance(const project::Points& a, const project::Points& b) {
  double distance = a.size() == b.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    distance = std::max({distance, std::abs(a[i].x - b[i].x), std::abs(a[i].y - b[i].y)});
  }
  return distance;
}

/// Any mesh whose border lies on that of the picture.
inline warp::Mesh random_mesh(std::mt19937& random, cv::Size size) {
  std::uniform_int_distribution<int> count(2, 12);
  std::uniform_real_distribution<double> x(0, size.width), y(0, size.height);
  warp::Mesh mesh{count(random), count(random), {}};
  for (int i = 0; i < mesh.columns * mesh.rows; ++i) mesh.vertices.emplace_back(x(random), y(random));
  for (int row = 0; row < mesh.rows; ++row) mesh.at(0, row).x = 0, mesh.at(mesh.columns - 1, row).x = size.width;
  for (int column = 0; column < mesh.columns; ++column)
    mesh.at(column, 0).y = 0, mesh.at(column, mesh.rows - 1).y = size.height;
  return mesh;
}

/// Any mesh without folds whose border lies on that of the picture.
inline warp::Mesh random_unfolded_mesh(std::mt19937& random, cv::Size size) {
  std::uniform_int_distribution<int> count(2, 12);
  warp::Mesh mesh = warp::uniform_mesh(count(random), count(random), {{0, 0}, cv::Size2d(size)});
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (cv::Point2d& vertex : mesh.vertices) {
    vertex.x += shift(random) * size.width / mesh.columns;
    vertex.y += shift(random) * size.height / mesh.rows;
  }
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(size)});
  return mesh;
}

}  // namespace morphkit::test
