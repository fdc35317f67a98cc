// Areas made of points; see antialias.h. Included by antialias_simd.cpp once per instruction set.
//
// Every pixel of a segment has a first point. Further points go into lists, so a pixel that is a point has the cost of
// a point, wherever it lies.

#if defined(MORPHKIT_WARP_ANTIALIAS_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_ANTIALIAS_POINTS_INL_H_
#undef MORPHKIT_WARP_ANTIALIAS_POINTS_INL_H_
#else
#define MORPHKIT_WARP_ANTIALIAS_POINTS_INL_H_
#endif

#include <cstddef>
#include <cstdint>
#include <span>

#include "hwy/highway.h"
#include "warp/sample/antialias.h"
#include "warp/sample/antialias_footprint-inl.h"
#include "warp/sample/reconstruct.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Pixels of a row with points read together.
constexpr size_t kSegment = 8 * kBlock;

/// Distance of the points from the middle. Their variance: a square's of side sigma, less a source pixel's.
HWY_INLINE FloatVec point_distance(FloatVec sigma) {
  const Floats d;
  const FloatVec side = hn::Min(sigma, hn::Set(d, kSumEnd));
  const FloatVec variance = hn::Mul(hn::MulAdd(side, side, hn::Set(d, -kOwnSquare)), hn::Set(d, 1.0F / 12));
  return hn::Sqrt(hn::Max(hn::Mul(ramp(sigma, kRampBegin, kRampEnd), variance), hn::Zero(d)));
}

/// A point or a displacement for each pixel of a vector.
struct PointVec {
  FloatVec x, y;
};
HWY_INLINE PointVec operator+(const PointVec& a, const PointVec& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)};
}
HWY_INLINE PointVec operator-(const PointVec& a, const PointVec& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
}

/// Displacements of the points of areas from the middle.
struct AreaPoints {
  HWY_INLINE AreaPoints(const Jacobian& j, const Decomposition& s) {
    const Floats d;
    const FloatVec zero = hn::Zero(d);
    const FloatVec first = point_distance(s.larger), second = point_distance(s.smaller);
    pair.x = hn::Mul(hn::Sqrt(hn::Max(s.xx, zero)), first);
    pair.y = hn::Mul(hn::CopySign(hn::Sqrt(hn::Max(s.yy, zero)), s.xy), first);
    four_part = ramp(hn::Div(second, hn::Max(first, hn::Set(d, 1e-20F))), 0, kFourPoints);
    if (hn::AllFalse(d, hn::Gt(four_part, zero))) {
      four_1 = four_2 = {zero, zero};
      return;
    }
    const FloatVec root_xx = hn::MulAdd(first, s.xx, hn::Mul(second, s.yy));
    const FloatVec root_xy = hn::Mul(hn::Sub(first, second), s.xy);
    const FloatVec root_yy = hn::MulAdd(first, s.yy, hn::Mul(second, s.xx));
    // R turns by the angle of (p, q), or mirrors.
    const auto mirrored = hn::Lt(s.det, zero);
    const FloatVec p = hn::IfThenElse(mirrored, hn::Sub(j.a, j.d), hn::Add(j.a, j.d));
    const FloatVec q = hn::IfThenElse(mirrored, hn::Add(j.c, j.b), hn::Sub(j.c, j.b));
    const FloatVec length = hn::Max(hn::Sqrt(hn::MulAdd(p, p, hn::Mul(q, q))), hn::Set(d, 1e-20F));
    const FloatVec cos = hn::Div(p, length), sin = hn::Div(q, length);
    const FloatVec other_x = hn::IfThenElse(mirrored, sin, hn::Neg(sin));
    const FloatVec other_y = hn::IfThenElse(mirrored, hn::Neg(cos), cos);
    four_1 = {hn::MulAdd(root_xx, cos, hn::Mul(root_xy, sin)), hn::MulAdd(root_xy, cos, hn::Mul(root_yy, sin))};
    four_2 = {hn::MulAdd(root_xx, other_x, hn::Mul(root_xy, other_y)),
              hn::MulAdd(root_xy, other_x, hn::Mul(root_yy, other_y))};
  }

  PointVec pair;            ///< d1 U1
  PointVec four_1, four_2;  ///< columns of S R
  FloatVec four_part;       ///< 0: two points; 1: four
};

/// kPoints further points each for some pixels of a segment.
template <size_t kPoints>
class PointList {
 public:
  void clear() { size_ = 0; }
  size_t size() const { return size_; }
  /// The pixel of an entry, as an index in the segment.
  size_t at(size_t entry) const { return static_cast<size_t>(at_[entry]); }

  /// Adds the pixels from `at` on that are in the mask.
  HWY_INLINE void add(hn::Mask<Floats> mask, size_t at, const PointVec (&points)[kPoints]) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    for (size_t k = 0; k < kPoints; ++k) {
      hn::StoreInterleaved2(hn::Compress(points[k].x, mask), hn::Compress(points[k].y, mask), d,
                            positions_[k] + 2 * size_);
    }
    const auto pixels = hn::Iota(di, static_cast<int32_t>(at));
    hn::StoreU(hn::Compress(pixels, hn::RebindMask(di, mask)), di, at_ + size_);
    size_ += hn::CountTrue(d, mask);
  }

  /// The colours of the k-th points of all entries.
  void read(const Image& source, Border border, size_t k, std::span<Pixel> colours) const {
    reconstruct_row(source, {reinterpret_cast<const MapPoint*>(positions_[k]), size_}, Kernel::kBicubic, border,
                    colours.first(size_));
  }

 private:
  // Room for whole vectors.
  static constexpr size_t kRoom = kSegment + hn::MaxLanes(Floats());
  float positions_[kPoints][2 * kRoom];
  int32_t at_[kRoom];
  size_t size_ = 0;
};

/// The points of a segment of a row.
class SegmentPoints {
 public:
  void clear() {
    pairs_.clear();
    fours_.clear();
    blends_.clear();
  }

  /// Adds a vector of pixels that are a point each.
  HWY_INLINE void add_points(const Points& middles, size_t at) {
    hn::StoreInterleaved2(middles.x, middles.y, Floats(), first_ + 2 * at);
  }

  /// Adds a vector of pixels that are a point each, except those in `areas`.
  HWY_INLINE void add_areas(const Points& middles, hn::Mask<Floats> areas, const AreaPoints& points, size_t at) {
    const Floats d;
    const PointVec middle{middles.x, middles.y};
    const auto has_four = hn::And(areas, hn::Gt(points.four_part, hn::Zero(d)));
    const auto only_four = hn::And(areas, hn::Ge(points.four_part, hn::Set(d, 1.0F)));
    PointVec first = middle - points.pair;
    pairs_.add(hn::AndNot(only_four, areas), at, {middle + points.pair});
    if (!hn::AllFalse(d, has_four)) {
      const PointVec up = middle - points.four_1, down = middle + points.four_1;
      const PointVec one = up - points.four_2, two = up + points.four_2, three = down - points.four_2,
                     four = down + points.four_2;
      first = {hn::IfThenElse(only_four, one.x, first.x), hn::IfThenElse(only_four, one.y, first.y)};
      fours_.add(only_four, at, {two, three, four});
      hn::StoreU(hn::Compress(points.four_part, hn::AndNot(only_four, has_four)), d, parts_ + blends_.size());
      blends_.add(hn::AndNot(only_four, has_four), at, {one, two, three, four});
    }
    hn::StoreInterleaved2(hn::IfThenElse(areas, first.x, middle.x), hn::IfThenElse(areas, first.y, middle.y), d,
                          first_ + 2 * at);
  }

  /// Reads the colours of the segment, out.size() pixels.
  void read(const Image& source, Border border, std::span<Pixel> out) {
    reconstruct_row(source, {reinterpret_cast<const MapPoint*>(first_), out.size()}, Kernel::kBicubic, border, out);
    if (pairs_.size() > 0) read_pairs(source, border, out);
    if (fours_.size() > 0) read_fours(source, border, out);
    if (blends_.size() > 0) read_blends(source, border, out);
  }

 private:
  HWY_NOINLINE void read_pairs(const Image& source, Border border, std::span<Pixel> out) {
    pairs_.read(source, border, 0, colours_[0]);
    for (size_t i = 0; i < pairs_.size(); ++i) {
      float* colour = out[pairs_.at(i)].val;
      for (size_t c = 0; c < 4; ++c) colour[c] = (colour[c] + colours_[0][i].val[c]) * 0.5F;
    }
  }

  HWY_NOINLINE void read_fours(const Image& source, Border border, std::span<Pixel> out) {
    for (size_t k = 0; k < 3; ++k) fours_.read(source, border, k, colours_[k]);
    for (size_t i = 0; i < fours_.size(); ++i) {
      float* colour = out[fours_.at(i)].val;
      for (size_t c = 0; c < 4; ++c) {
        colour[c] = ((colour[c] + colours_[0][i].val[c]) + (colours_[1][i].val[c] + colours_[2][i].val[c])) * 0.25F;
      }
    }
  }

  HWY_NOINLINE void read_blends(const Image& source, Border border, std::span<Pixel> out) {
    for (size_t k = 0; k < 4; ++k) blends_.read(source, border, k, colours_[k]);
    for (size_t i = 0; i < blends_.size(); ++i) {
      Pixel& pixel = out[blends_.at(i)];
      const Pixel mean = ((colours_[0][i] + colours_[1][i]) + (colours_[2][i] + colours_[3][i])) * 0.25F;
      pixel += (mean - pixel) * parts_[i];
    }
  }

  alignas(64) float first_[2 * kSegment];
  PointList<1> pairs_;                              ///< the second points of two
  PointList<3> fours_;                              ///< the last three of four
  PointList<4> blends_;                             ///< four beside two
  float parts_[kSegment + hn::MaxLanes(Floats())];  ///< of the mean of four
  Pixel colours_[4][kSegment];
};

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
