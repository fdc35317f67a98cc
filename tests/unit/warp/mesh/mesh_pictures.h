#pragma once
// Meshes for pictures with known values at every point. For the quality test and the benchmark of the mesh warp.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/parallel.h"
#include "tests/support/known_pictures.h"
#include "warp/mesh/mesh_warp.h"

namespace morphkit::test {

/// The zone plate and its radial map as meshes. The border of a mesh lies on its outline, but the radial map does not
/// keep it there. So both images and the plate extend beyond the measured part, and in this margin the vertices move
/// gradually from the radial map to the outline.
class ZonePlate {
 public:
  static constexpr int kVertices = 129;
  static constexpr int kSourceSize = 2688;
  static constexpr int kMeasuredSize = 1024;
  static constexpr int kMargin = 64;
  static constexpr int kOutputSize = kMeasuredSize + 2 * kMargin;

  /// The part of the output that is measured.
  static cv::Rect measured() {
    constexpr int kBorder = kMargin + 8;
    return {kBorder, kBorder, kOutputSize - 2 * kBorder, kOutputSize - 2 * kBorder};
  }

  static RadialPlate plate() { return {kSourceSize, kOutputSize}; }

  static double value(cv::Point2d source) { return plate().value(source); }

  static warp::Image source() {
    return grey_image({kSourceSize, kSourceSize}, [](double x, double y) { return value({x, y}); });
  }

  static cv::Point2d radial(cv::Point2d output) { return plate().radial(output); }

  static warp::Mesh to() {
    return warp::uniform_mesh(kVertices, kVertices, cv::Rect2d(0, 0, kOutputSize, kOutputSize));
  }

  static warp::Mesh from() {
    warp::Mesh mesh = to();
    for (cv::Point2d& vertex : mesh.vertices) {
      const cv::Point2d inside = radial(vertex);
      vertex = {drawn_out(vertex.x, inside.x), drawn_out(vertex.y, inside.y)};
    }
    warp::snap_to_outline(mesh, cv::Rect2d(0, 0, kSourceSize, kSourceSize));
    return mesh;
  }

 private:
  static constexpr double kUntouched = 28;  // output px around the measured part that are still radial

  /// From the radial map's coordinate at the edge of the untouched part to the outline at the margin's end.
  static double drawn_out(double output, double inside) {
    const double from_middle = std::abs(output - kOutputSize / 2.0) - kMeasuredSize / 2.0;
    const double way = std::clamp((from_middle - kUntouched) / (kMargin - kUntouched), 0.0, 1.0);
    return std::lerp(inside, output < kOutputSize / 2.0 ? 0.0 : kSourceSize, way);
  }
};

/// A uniform mesh with moved inner vertices: a smooth swirl of up to `swirl` of the image, plus a random shift of up to
/// `jitter` of the distance to the neighbours.
inline warp::Mesh bent_mesh(int columns, int rows, cv::Size size, double swirl, double jitter, unsigned seed) {
  const cv::Rect2d outline(0, 0, size.width, size.height);
  warp::Mesh mesh = warp::uniform_mesh(columns, rows, outline);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (cv::Point2d& vertex : mesh.vertices) {
    const double x = vertex.x / size.width;
    const double y = vertex.y / size.height;
    const double way = swirl * std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y);
    vertex.x += size.width * way * std::cos(5 * y + seed) + jitter * uniform(random) * size.width / (columns - 1);
    vertex.y += size.height * way * std::sin(5 * x + seed) + jitter * uniform(random) * size.height / (rows - 1);
  }
  warp::snap_to_outline(mesh, outline);
  return mesh;
}

/// The exact map of `warp` at every `stride`-th output pixel of `area`, at `offset` in [0, 1] from its corner. It is
/// the map of the output mesh reduced by `stride`.
inline warp::Map sparse_map(const warp::MeshWarp& warp, cv::Rect area, int stride, cv::Point2d offset) {
  warp::Mesh to = warp.to();
  const cv::Point2d origin = cv::Point2d(area.tl()) + offset;
  for (cv::Point2d& vertex : to.vertices) vertex = (vertex - origin) / stride + cv::Point2d(0.5, 0.5);
  const cv::Size size((area.width + stride - 1) / stride, (area.height + stride - 1) / stride);
  return warp::MeshWarp(warp.from(), to, {warp::MeshSpline::kMonotone, warp.order()}).map(size);
}

/// The mean of 16 x 16 samples of the picture over every `stride`-th pixel and row of `area`, through the exact map of
/// `warp`. The spline of `warp` must be monotone.
template <typename Value>
std::vector<ReferencePixel> reference_pixels(const warp::MeshWarp& warp, cv::Rect area, int stride,
                                             const Value& value) {
  constexpr int kSamples = 16;
  std::vector<ReferencePixel> pixels;
  for (int y = area.y; y < area.br().y; y += stride) {
    for (int x = area.x; x < area.br().x; x += stride) pixels.push_back({{x, y}, 0});
  }
  for (int sample = 0; sample < kSamples * kSamples; ++sample) {
    const cv::Point2d offset = cv::Point2d(cv::Point(sample % kSamples, sample / kSamples)) + cv::Point2d(0.5, 0.5);
    const warp::Map map = sparse_map(warp, area, stride, offset / kSamples);
    for_rows(map.rows, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < map.cols; ++x) {
          const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(map.cols) + static_cast<std::size_t>(x);
          pixels[i].grey += value(cv::Point2d(cv::Vec2d(map(y, x)))) / (kSamples * kSamples);
        }
      }
    });
  }
  return pixels;
}

}  // namespace morphkit::test
