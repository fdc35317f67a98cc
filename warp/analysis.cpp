#include "warp/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <tuple>

#include "base/parallel.h"

namespace morphkit::warp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Columns of J: the change of the source position per pixel in x and in y.
struct Jacobian {
  cv::Vec2d dx;
  cv::Vec2d dy;

  double determinant() const { return dx[0] * dy[1] - dy[0] * dx[1]; }

  /// (larger, smaller). J is the sum of a similarity and an anti-similarity; the singular values are the sum and the
  /// difference of their scales (Blinn, "Consider the Lowly 2x2 Matrix", IEEE CG&A 16(2), 1996).
  cv::Vec2d singular_values() const {
    const double similarity = std::hypot(dx[0] + dy[1], dx[1] - dy[0]) / 2;
    const double anti = std::hypot(dx[0] - dy[1], dx[1] + dy[0]) / 2;
    return {similarity + anti, std::abs(similarity - anti)};
  }
};

bool is_finite(const cv::Vec2d& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]);
}

/// The difference along one axis around index i of n, per pixel; `unit` where the axis has a single pixel.
template <typename At>
cv::Vec2d difference(int i, int n, const cv::Vec2d& unit, const At& at) {
  if (n == 1) return unit;
  const int before = std::max(i - 1, 0);
  const int after = std::min(i + 1, n - 1);
  return (cv::Vec2d(at(after)) - cv::Vec2d(at(before))) * (1.0 / (after - before));
}

/// nullopt where the map or a neighbour in use is not finite.
std::optional<Jacobian> jacobian_at(const Map& map, int x, int y) {
  if (!is_finite(map(y, x))) return std::nullopt;
  const Jacobian j{difference(x, map.cols, {1, 0}, [&](int i) { return map(y, i); }),
                   difference(y, map.rows, {0, 1}, [&](int i) { return map(i, x); })};
  if (!is_finite(j.dx) || !is_finite(j.dy)) return std::nullopt;
  return j;
}

/// An image of fn(J) for every pixel of the map.
template <typename Value, typename Fn>
cv::Mat_<Value> per_pixel(const Map& map, const Value& nothing, const Fn& fn) {
  cv::Mat_<Value> result(map.size());
  for_rows(map.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        const std::optional<Jacobian> j = jacobian_at(map, x, y);
        result(y, x) = j ? fn(*j) : nothing;
      }
    }
  });
  return result;
}

}  // namespace

cv::Mat1f jacobian_determinant(const Map& map) {
  return per_pixel<float>(map, kNan, [](const Jacobian& j) { return static_cast<float>(j.determinant()); });
}

cv::Mat2f stretch(const Map& map) {
  return per_pixel<cv::Vec2f>(map, {kNan, kNan}, [](const Jacobian& j) { return cv::Vec2f(j.singular_values()); });
}

std::vector<FoldRegion> find_folds(const Map& map) {
  if (map.empty()) return {};
  const cv::Mat1b folded =
      per_pixel<uchar>(map, 0, [](const Jacobian& j) -> uchar { return j.determinant() <= 0 ? 255 : 0; });
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(folded, labels, stats, centroids, 8, CV_32S);
  std::vector<FoldRegion> regions;
  for (int i = 1; i < count; ++i) {  // 0 is the background
    regions.push_back({.area_px = stats(i, cv::CC_STAT_AREA),
                       .bounds = {stats(i, cv::CC_STAT_LEFT), stats(i, cv::CC_STAT_TOP), stats(i, cv::CC_STAT_WIDTH),
                                  stats(i, cv::CC_STAT_HEIGHT)},
                       // From pixel numbers to the pixels' centres.
                       .centroid = {centroids(i, 0) + 0.5, centroids(i, 1) + 0.5}});
  }
  const auto key = [](const FoldRegion& r) {
    return std::tuple(-r.area_px, r.bounds.y, r.bounds.x, r.centroid.y, r.centroid.x);
  };
  std::ranges::sort(regions, {}, key);
  return regions;
}

StretchRange stretch_range(const Map& map) {
  StretchRange range{std::numeric_limits<double>::infinity(), 0};
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const std::optional<Jacobian> j = jacobian_at(map, x, y);
      if (!j) continue;
      const cv::Vec2d values = j->singular_values();
      range = {std::min(range.smallest, values[1]), std::max(range.largest, values[0])};
    }
  }
  return range.smallest <= range.largest ? range : StretchRange{};
}

}  // namespace morphkit::warp
