#include "warp/sample/antialias.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "warp/sample/border.h"
#include "warp/sample/filters.h"
#include "warp/sample/reconstruct.h"

namespace morphkit::warp::detail {
namespace {

/// The integral of the Catmull-Rom kernel [Keys 1981, eq. 15] from 0 to d.
double catmull_rom_integral(double d) {
  const double a = std::min(std::abs(d), 2.0);
  const double rest = 2 - a;
  const double value = a < 1 ? a - 5.0 / 6 * a * a * a + 3.0 / 8 * a * a * a * a
                             : 0.5 + rest * rest * rest / 6 - rest * rest * rest * rest / 8;
  return std::copysign(value, d);
}

/// One coordinate of a footprint: u = row . (source - position).
template <typename Filter>
class Axis {
 public:
  explicit Axis(const cv::Vec2d& row) : row_(row) {
    if constexpr (Filter::kIsSlab) {
      // The slab |u| < 1/2, filtered by the reconstruction kernel: in source pixels, along the slab's normal.
      const double pixels = 1 / cv::norm(row);
      half_ = std::sqrt(pixels * pixels - static_cast<double>(kOwnSquare)) / 2;
      row_ *= pixels;
      reach_ = half_ + 2;
    } else {
      reach_ = static_cast<double>(Filter::kReach);
    }
  }

  double weight(const cv::Vec2d& offset) const {
    const double u = row_.dot(offset);
    if constexpr (Filter::kIsSlab) {
      return catmull_rom_integral(u + half_) - catmull_rom_integral(u - half_);
    } else {
      return Filter::weight(u);
    }
  }

  cv::Vec2d row() const { return row_; }
  double reach() const { return reach_; }

 private:
  cv::Vec2d row_;
  double half_ = 0, reach_ = 0;
};

bool is_finite(const MapPoint& position) {
  return std::isfinite(position[0]) && std::isfinite(position[1]);
}

cv::Vec2d held(const MapPoint& position) {
  return {static_cast<double>(std::clamp(position[0], -kFarthestPosition, kFarthestPosition)),
          static_cast<double>(std::clamp(position[1], -kFarthestPosition, kFarthestPosition))};
}

/// The difference between both neighbours, or between the pixel and its only neighbour.
std::optional<cv::Vec2d> derivative(const Map& positions, cv::Point at, cv::Point step) {
  const auto neighbour = [&](cv::Point p) -> std::optional<cv::Vec2d> {
    if (!cv::Rect(cv::Point(), positions.size()).contains(p) || !is_finite(positions(p))) return std::nullopt;
    return held(positions(p));
  };
  const auto before = neighbour(at - step);
  const auto after = neighbour(at + step);
  if (!before && !after) return std::nullopt;
  const cv::Vec2d middle = held(positions(at));
  return (after.value_or(middle) - before.value_or(middle)) * (before && after ? 0.5 : 1.0);
}

/// In a direction without neighbours, the map counts as a similarity.
cv::Matx22d jacobian(const Map& positions, cv::Point at) {
  const auto along_x = derivative(positions, at, {1, 0});
  const auto along_y = derivative(positions, at, {0, 1});
  if (!along_x && !along_y) return cv::Matx22d::zeros();
  const cv::Vec2d x = along_x ? *along_x : cv::Vec2d((*along_y)[1], -(*along_y)[0]);
  const cv::Vec2d y = along_y ? *along_y : cv::Vec2d(-(*along_x)[1], (*along_x)[0]);
  return {x[0], y[0], x[1], y[1]};
}

template <typename Filter>
cv::Vec4d footprint_mean(const Image& source, cv::Vec2d position, const Axis<Filter>& u, const Axis<Filter>& v,
                         Border border) {
  const double inverse = 1 / std::abs(u.row()[0] * v.row()[1] - u.row()[1] * v.row()[0]);
  const double reach_x = (std::abs(v.row()[1]) * u.reach() + std::abs(u.row()[1]) * v.reach()) * inverse;
  const double reach_y = (std::abs(v.row()[0]) * u.reach() + std::abs(u.row()[0]) * v.reach()) * inverse;
  cv::Vec4d sum;
  double weights = 0;
  for (double y = std::ceil(position[1] - reach_y - 0.5); y <= position[1] + reach_y - 0.5; ++y) {
    const int row = index_within(static_cast<std::int64_t>(y), source.rows, border);
    for (double x = std::ceil(position[0] - reach_x - 0.5); x <= position[0] + reach_x - 0.5; ++x) {
      const cv::Vec2d offset = cv::Vec2d(x + 0.5, y + 0.5) - position;
      const double weight = u.weight(offset) * v.weight(offset);
      weights += weight;
      const int column = index_within(static_cast<std::int64_t>(x), source.cols, border);
      if (row >= 0 && column >= 0) sum += weight * cv::Vec4d(source(row, column));
    }
  }
  return sum / weights;
}

/// From 0 at `begin` to 1 at `end`.
double ramp(double value, float begin, float end) {
  const double from = static_cast<double>(begin);
  const double way = std::clamp((value - from) / (static_cast<double>(end) - from), 0.0, 1.0);
  return way * way * (3 - 2 * way);
}

/// Distance of the points from the middle. Their variance: a square's of side sigma, less a source pixel's.
double point_distance(double sigma) {
  const double side = std::min(sigma, static_cast<double>(kSumEnd));
  const double variance = (side * side - static_cast<double>(kOwnSquare)) / 12;
  return std::sqrt(std::max(ramp(sigma, kRampBegin, kRampEnd) * variance, 0.0));
}

/// An area as points; see antialias.h.
Pixel mean_of_points(const Image& source, const MapPoint& middle, const cv::SVD& svd, Border border) {
  const auto at = [&](const cv::Vec2d& offset) {
    const MapPoint position(static_cast<float>(static_cast<double>(middle[0]) + offset[0]),
                            static_cast<float>(static_cast<double>(middle[1]) + offset[1]));
    Pixel colour;
    reconstruct_row(source, {&position, 1}, Kernel::kBicubic, border, {&colour, 1});
    return cv::Vec4d(colour);
  };
  const cv::Matx22d u(svd.u), turn = u * cv::Matx22d(svd.vt);
  const double first = point_distance(svd.w.at<double>(0)), second = point_distance(svd.w.at<double>(1));
  const cv::Vec2d pair = u * cv::Vec2d(first, 0);
  const cv::Matx22d root = u * cv::Matx22d::diag({first, second}) * u.t() * turn;
  const cv::Vec4d two = (at(pair) + at(-pair)) / 2;
  cv::Vec4d four;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) four += at(root * cv::Vec2d(x, y)) / 4;
  }
  const double part = first > 0 ? ramp(second / first, 0, kFourPoints) : 0;
  return Pixel(two + part * (four - two));
}

void finish(cv::Vec4d mean, double blend, Pixel& pixel) {
  constexpr double kMax = std::numeric_limits<float>::max();
  for (int c = 0; c < 4; ++c) {
    const double value = std::clamp(mean[c], c == 3 ? 0.0 : -kMax, c == 3 ? 1.0 : kMax);
    pixel[c] = static_cast<float>(std::lerp(static_cast<double>(pixel[c]), value, blend));
  }
}

template <typename Filter>
void antialias_reference(const Image& source, const Map& positions, Border border, Image& out) {
  const auto width = static_cast<std::size_t>(positions.cols);
  constexpr double kMost = static_cast<double>(Filter::kMostStretch);
  for (int y = 0; y < positions.rows; ++y) {
    reconstruct_row(source, {positions[y], width}, Kernel::kBicubic, border, {out[y], width});
    for (int x = 0; x < positions.cols; ++x) {
      if (!is_finite(positions(y, x))) continue;
      const cv::SVD svd(jacobian(positions, {x, y}));
      const cv::Vec2d stretch(svd.w.at<double>(0), svd.w.at<double>(1));
      if (Filter::kHasPoints && stretch[0] > static_cast<double>(kRampBegin))
        out(y, x) = mean_of_points(source, positions(y, x), svd, border);
      const double blend =
          Filter::kHasPoints ? ramp(stretch[0], kSumBegin, kSumEnd) : ramp(stretch[0], kRampBegin, kRampEnd);
      if (blend == 0) continue;
      const cv::Matx22d shrink =
          cv::Matx22d::diag({1 / std::clamp(stretch[0], 1.0, kMost), 1 / std::clamp(stretch[1], 1.0, kMost)});
      const cv::Matx22d rows = cv::Matx22d(svd.vt).t() * shrink * cv::Matx22d(svd.u).t();
      const Axis<Filter> u({rows(0, 0), rows(0, 1)});
      const Axis<Filter> v({rows(1, 0), rows(1, 1)});
      finish(footprint_mean(source, held(positions(y, x)), u, v, border), blend, out(y, x));
    }
  }
}

}  // namespace

void reference_antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out) {
  AntialiasingFilters::visit(filter, [&](auto f) { antialias_reference<decltype(f)>(source, positions, border, out); });
}

}  // namespace morphkit::warp::detail
