// The kernel behind antialiased sampling. Footprints are told in lanes over pixels of the output, weights in lanes over
// pixels of the source, colours are summed in lanes over channels.
//
// A mean is written as "the nearest pixel plus weighted differences from it": a constant comes out unchanged, to the
// bit, so an opaque image stays opaque.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "warp/antialias.h"
#include "warp/border.h"
#include "warp/reconstruct.h"

// Machines without a fixed vector size have NEON too; see area_resample_simd.cpp.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/antialias_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

#include "warp/antialias_footprint-inl.h"
#include "warp/antialias_sum-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

/// The positions of a band, with what lies around each row.
class Band {
 public:
  explicit Band(const Map& positions) : positions_(positions), width_(static_cast<size_t>(positions.cols)) {}

  /// Of kBlock pixels; those beyond the edge of the band are not numbers.
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

/// The points that a block's pixels are made of: one, or two and four in parts.
class BlockPoints {
 public:
  /// @param pixel  where the colour goes.
  void add_point(const MapPoint& middle, Pixel& pixel) { add(middle, pixel, 1, 0); }

  void add_area(const MapPoint& middle, const Footprints& f, size_t i, Pixel& pixel) {
    const MapPoint pair(f.pair_x[i], f.pair_y[i]);
    if (pair == MapPoint(0, 0)) return add_point(middle, pixel);
    const float part = f.four_part[i];
    if (part < 1) {
      add(middle - pair, pixel, 2, 1 - part);
      positions_[size_++] = middle + pair;
    }
    if (part > 0) {
      const MapPoint first(f.four_x1[i], f.four_y1[i]), second(f.four_x2[i], f.four_y2[i]);
      add(middle - first - second, pixel, 4, part);
      for (const MapPoint& position : {middle - first + second, middle + first - second, middle + first + second})
        positions_[size_++] = position;
    }
  }

  void read(const Image& source, Border border) {
    reconstruct_row(source, {positions_.data(), size_}, Kernel::kBicubic, border, {colours_.data(), size_});
    const Pixel* next = colours_.data();
    for (size_t i = 0; i < groups_; ++i) {
      const Group& group = group_[i];
      if (group.count == 1) *group.pixel = next[0];
      if (group.count == 2) *group.pixel = (next[0] + next[1]) * 0.5F;
      if (group.count == 4) {
        const Pixel mean = ((next[0] + next[1]) + (next[2] + next[3])) * 0.25F;
        *group.pixel = group.part < 1 ? *group.pixel + (mean - *group.pixel) * group.part : mean;
      }
      next += group.count;
    }
  }

 private:
  struct Group {
    Pixel* pixel;
    size_t count;  ///< of points
    float part;    ///< of four points, that of the mean; two come before
  };

  void add(const MapPoint& position, Pixel& pixel, size_t count, float part) {
    group_[groups_++] = {&pixel, count, part};
    positions_[size_++] = position;
  }

  std::array<MapPoint, 6 * kBlock> positions_;
  std::array<Pixel, 6 * kBlock> colours_;
  std::array<Group, 2 * kBlock> group_;
  size_t size_ = 0, groups_ = 0;
};

template <Filter kFilter>
void antialias_rows(const Image& source, const Map& positions, Border border, Image& out) {
  const auto width = static_cast<size_t>(positions.cols);
  const Summer<kFilter> summer(source, border);
  Band band(positions);
  Footprints footprints;
  for (int y = 0; y < positions.rows; ++y) {
    size_t run = 0;  // where the run of blocks begins whose pixels are one point each
    const auto end_run = [&](size_t end) {
      if (run == end) return;
      reconstruct_row(source, {positions[y] + run, end - run}, Kernel::kBicubic, border, {out[y] + run, end - run});
    };
    for (size_t x = 0; x < width; x += kBlock) {
      const Neighbours around = band.around(y, x);
      if (all_points(around) || !find_footprints<kFilter>(around, footprints)) continue;
      end_run(x);
      const size_t count = std::min(kBlock, width - x);
      run = x + count;
      BlockPoints points;
      for (size_t i = 0; i < count; ++i) {
        if (footprints.blend[i] >= 1) continue;
        if constexpr (kFilter == Filter::kArea) {
          points.add_area(positions[y][x + i], footprints, i, out[y][x + i]);
        } else {
          points.add_point(positions[y][x + i], out[y][x + i]);
        }
      }
      points.read(source, border);
      for (size_t i = 0; i < count; ++i) {
        if (footprints.blend[i] > 0) summer.blend(positions[y][x + i], footprints, i, out[y][x + i]);
      }
    }
    end_run(width);
  }
}

void antialias_area(const Image& source, const Map& positions, Border border, Image& out) {
  antialias_rows<Filter::kArea>(source, positions, border, out);
}
void antialias_mitchell(const Image& source, const Map& positions, Border border, Image& out) {
  antialias_rows<Filter::kMitchell>(source, positions, border, out);
}
void antialias_lanczos(const Image& source, const Map& positions, Border border, Image& out) {
  antialias_rows<Filter::kLanczos>(source, positions, border, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {
HWY_EXPORT(antialias_area);
HWY_EXPORT(antialias_mitchell);
HWY_EXPORT(antialias_lanczos);

void antialias_band(const Image& source, const Map& positions, Filter filter, Border border, Image& out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  assert(is_antialiasing(filter));
  if (filter == Filter::kMitchell) {
    HWY_DYNAMIC_DISPATCH(antialias_mitchell)(source, positions, border, out);
  } else if (filter == Filter::kLanczos) {
    HWY_DYNAMIC_DISPATCH(antialias_lanczos)(source, positions, border, out);
  } else {
    HWY_DYNAMIC_DISPATCH(antialias_area)(source, positions, border, out);
  }
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
