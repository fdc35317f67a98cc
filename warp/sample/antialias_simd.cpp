// The kernel behind antialiased sampling. Footprints are computed in lanes over pixels of the output, weights in lanes
// over pixels of the source, and colours in lanes over channels.
//
// A mean is written as "the nearest pixel plus weighted differences from it": a constant stays the same to the bit, so
// an opaque image stays opaque.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "base/kernel_targets.h"
#include "warp/sample/antialias.h"
#include "warp/sample/border.h"
#include "warp/sample/filters.h"
#include "warp/sample/reconstruct.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/sample/antialias_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

#include "warp/sample/antialias_footprint-inl.h"
#include "warp/sample/antialias_points-inl.h"
#include "warp/sample/antialias_sum-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

/// The positions of a band, with the neighbours of each row.
class Band {
 public:
  explicit Band(const Map& positions) : positions_(positions), width_(static_cast<size_t>(positions.cols)) {}

  /// The neighbours of kBlock pixels; beyond the edge of the band they are NaN.
  Neighbours around(int y, size_t x) {
    const bool first = y == 0;
    const bool last = y == positions_.rows - 1;
    Neighbours n;
    n.has_above = !first;
    n.has_below = !last;
    const MapPoint* rows[3] = {positions_[first ? y : y - 1], positions_[y], positions_[last ? y : y + 1]};
    if (x > 0 && x + kBlock < width_) {
      n.above = rows[0][x].val;
      n.centre = rows[1][x].val;
      n.below = rows[2][x].val;
      return n;
    }
    // One pixel more on either side.
    const float* copies[3];
    const size_t begin = x == 0 ? 0 : x - 1;
    const size_t end = std::min(x + kBlock + 1, width_);
    for (size_t i = 0; i < 3; ++i) {
      edge_[i].fill(MapPoint::all(std::numeric_limits<float>::quiet_NaN()));
      std::copy(rows[i] + begin, rows[i] + end, edge_[i].begin() + (x == 0 ? 1 : 0));
      copies[i] = edge_[i][1].val;
    }
    n.above = copies[0];
    n.centre = copies[1];
    n.below = copies[2];
    return n;
  }

 private:
  const Map& positions_;
  size_t width_;
  std::array<std::array<MapPoint, kBlock + 2>, 3> edge_;
};

/// The rows of a band, segment by segment.
template <typename Filter>
class Rows {
 public:
  Rows(const Image& source, const Map& positions, Border border)
      : source_(source), positions_(positions), border_(border), band_(positions), summer_(source, border) {}

  void run(int y, size_t begin, std::span<Pixel> out) {
    points_.clear();
    sums_ = 0;
    for (size_t at = 0; at < out.size(); at += kBlock) add_block(band_.around(y, begin + at), y, begin, at);
    points_.read(source_, border_, out);
    for (size_t i = 0; i < sums_; ++i) {
      const Sum& sum = sum_[i];
      Pixel& pixel = out[sum.at];
      pixel = sum.part < 1 ? pixel + sum.part * (sum.mean - pixel) : sum.mean;
    }
  }

 private:
  struct Sum {
    size_t at;
    float part;
    Pixel mean;
  };

  void add_block(const Neighbours& around, int y, size_t begin, size_t at) {
    const Floats d;
    bool any_sum = false;
    for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
      if (all_points(around, i)) {
        points_.add_points(Points(around.centre + 2 * i), at + i);
        hn::Store(hn::Zero(d), d, footprints_.blend + i);
      } else {
        any_sum = add_areas(around, i, at) || any_sum;
      }
    }
    if (any_sum) add_sums(y, begin, at);
  }

  /// Adds the areas of a vector of pixels. @return  whether any has a sum.
  HWY_NOINLINE bool add_areas(const Neighbours& around, size_t i, size_t at) {
    constexpr bool kHasPoints = Filter::kHasPoints;
    const Floats d;
    const Points centre(around.centre + 2 * i);
    const Jacobian j = jacobian(around, i, centre);
    const Decomposition shape(j);
    const auto here = finite(centre);
    const FloatVec smooth =
        kHasPoints ? ramp(shape.larger, kSumBegin, kSumEnd) : ramp(shape.larger, kRampBegin, kRampEnd);
    const FloatVec blend = hn::IfThenElseZero(here, smooth);
    make_footprints<Filter>(j, shape, blend, i, footprints_);
    const auto grows = hn::And(here, hn::Gt(shape.larger, hn::Set(d, kRampBegin)));
    const auto areas = hn::And(grows, hn::Lt(blend, hn::Set(d, 1.0F)));
    if (!kHasPoints || hn::AllFalse(d, areas)) {
      points_.add_points(centre, at + i);
    } else {
      points_.add_areas(centre, areas, AreaPoints(j, shape), at + i);
    }
    return !hn::AllFalse(d, hn::Gt(blend, hn::Zero(d)));
  }

  HWY_NOINLINE void add_sums(int y, size_t begin, size_t at) {
    for (size_t i = 0; i < kBlock; ++i) {
      if (footprints_.blend[i] <= 0) continue;
      sum_[sums_++] = {at + i, footprints_.blend[i], summer_.mean(positions_[y][begin + at + i], footprints_, i)};
    }
  }

  const Image& source_;
  const Map& positions_;
  Border border_;
  Band band_;
  Summer<Filter> summer_;
  Footprints footprints_;
  SegmentPoints points_;
  std::array<Sum, kSegment> sum_;
  size_t sums_ = 0;
};

template <typename Filter>
void antialias_rows(const Image& source, const Map& positions, Border border, Image& out) {
  const auto width = static_cast<size_t>(positions.cols);
  Rows<Filter> rows(source, positions, border);
  for (int y = 0; y < positions.rows; ++y) {
    for (size_t x = 0; x < width; x += kSegment) rows.run(y, x, {out[y] + x, std::min(kSegment, width - x)});
  }
}

void antialias_rows_of(Filter filter, const Image& source, const Map& positions, Border border, Image& out) {
  AntialiasingFilters::visit(filter, [&](auto f) { antialias_rows<decltype(f)>(source, positions, border, out); });
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {
HWY_EXPORT(antialias_rows_of);

void antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  assert(AntialiasingFilters::contains(filter));
  HWY_DYNAMIC_DISPATCH(antialias_rows_of)(filter, source, positions, border, out);
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
