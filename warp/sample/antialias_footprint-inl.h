// The position and extent of output pixels in the source, in lanes over pixels. Included by antialias_simd.cpp once per
// instruction set.

#if defined(MORPHKIT_WARP_ANTIALIAS_FOOTPRINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_ANTIALIAS_FOOTPRINT_INL_H_
#undef MORPHKIT_WARP_ANTIALIAS_FOOTPRINT_INL_H_
#else
#define MORPHKIT_WARP_ANTIALIAS_FOOTPRINT_INL_H_
#endif

#include <cstddef>

#include "hwy/highway.h"
#include "warp/sample/antialias.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using FloatVec = hn::Vec<Floats>;

/// Pixels with footprints computed together.
constexpr size_t kBlock = 64;

/// Interleaved positions of a block, of the pixels to its left and right, and of the rows above and below (the block's
/// own row where there is none).
struct Neighbours {
  const float *above = nullptr, *centre = nullptr, *below = nullptr;
  bool has_above = false, has_below = false;
};

/// The footprints of a block: u and v are row . (source - position); from u_reach, v_reach on the weight is 0.
struct Footprints {
  alignas(64) float blend[kBlock];  ///< 0: points; 1: a sum only
  alignas(64) float ux[kBlock], uy[kBlock], vx[kBlock], vy[kBlock];
  alignas(64) float u_half[kBlock], v_half[kBlock];  ///< of the area's slabs
  alignas(64) float u_reach[kBlock], v_reach[kBlock];
  alignas(64) float x_reach[kBlock], y_reach[kBlock];  ///< of both together, source px
};

/// J by rows: (a b) is the change of x along the output's x and y, (c d) the change of y.
struct Jacobian {
  FloatVec a, b, c, d;
};

/// Two coordinates of a vector's worth of pixels.
struct Points {
  HWY_INLINE explicit Points(const float* interleaved) { hn::LoadInterleaved2(Floats(), interleaved, x, y); }
  FloatVec x, y;
};

/// Whether every pixel of the vector that begins at the block's i-th pixel is a point: both singular values of J are
/// below kRampBegin. With q = kRampBegin^2, this holds if and only if the polynomial that has the squared singular
/// values as roots is positive at q and has its minimum left of q. NaN is not a point.
HWY_INLINE bool all_points(const Neighbours& n, size_t i) {
  if (!n.has_above && !n.has_below) return false;
  const Floats d;
  constexpr float kSquare = kRampBegin * kRampBegin;
  const FloatVec half = hn::Set(d, 0.5F);
  const FloatVec scale_y = hn::Set(d, n.has_above && n.has_below ? 0.5F : 1.0F);
  const Points left(n.centre + 2 * i - 2), right(n.centre + 2 * i + 2), above(n.above + 2 * i), below(n.below + 2 * i);
  const FloatVec ja = hn::Mul(hn::Sub(right.x, left.x), half);
  const FloatVec jc = hn::Mul(hn::Sub(right.y, left.y), half);
  const FloatVec jb = hn::Mul(hn::Sub(below.x, above.x), scale_y);
  const FloatVec jd = hn::Mul(hn::Sub(below.y, above.y), scale_y);
  const FloatVec sum = hn::MulAdd(ja, ja, hn::MulAdd(jb, jb, hn::MulAdd(jc, jc, hn::Mul(jd, jd))));
  const FloatVec det = hn::Sub(hn::Mul(ja, jd), hn::Mul(jb, jc));
  const FloatVec value = hn::MulAdd(det, det, hn::NegMulAdd(sum, hn::Set(d, kSquare), hn::Set(d, kSquare * kSquare)));
  const auto point = hn::And(hn::Ge(value, hn::Zero(d)), hn::Le(sum, hn::Set(d, 2 * kSquare)));
  return hn::AllTrue(d, point);
}

HWY_INLINE hn::Mask<Floats> finite(const Points& p) {
  return hn::And(hn::IsFinite(p.x), hn::IsFinite(p.y));
}

HWY_INLINE FloatVec held(FloatVec position) {
  const FloatVec far = hn::Set(Floats(), kFarthestPosition);
  return hn::Min(hn::Max(position, hn::Neg(far)), far);
}

/// The difference between both neighbours, or between the pixel and its only neighbour.
struct Derivative {
  HWY_INLINE Derivative(const Points& before, hn::Mask<Floats> has_before, const Points& middle, const Points& after,
                        hn::Mask<Floats> has_after)
      : known(hn::Or(has_before, has_after)) {
    const Floats d;
    const FloatVec one = hn::Set(d, 1.0F);
    const FloatVec factor = hn::IfThenElse(hn::And(has_before, has_after), hn::Set(d, 0.5F), one);
    const auto difference = [&](FloatVec b, FloatVec m, FloatVec a) {
      const FloatVec here = held(m);
      return hn::Mul(hn::Sub(hn::IfThenElse(has_after, held(a), here), hn::IfThenElse(has_before, held(b), here)),
                     factor);
    };
    x = difference(before.x, middle.x, after.x);
    y = difference(before.y, middle.y, after.y);
  }

  FloatVec x, y;
  hn::Mask<Floats> known;
};

HWY_INLINE hn::Mask<Floats> all_or_none(bool all) {
  return hn::FirstN(Floats(), all ? hn::Lanes(Floats()) : 0);
}

/// In a direction without neighbours, the map counts as a similarity.
HWY_INLINE Jacobian jacobian(const Neighbours& n, size_t i, const Points& centre) {
  const Points left(n.centre + 2 * i - 2), right(n.centre + 2 * i + 2), above(n.above + 2 * i), below(n.below + 2 * i);
  const Derivative x(left, finite(left), centre, right, finite(right));
  const Derivative y(above, hn::And(finite(above), all_or_none(n.has_above)), centre, below,
                     hn::And(finite(below), all_or_none(n.has_below)));
  return {hn::IfThenElse(x.known, x.x, y.y), hn::IfThenElse(y.known, y.x, hn::Neg(x.y)),
          hn::IfThenElse(x.known, x.y, hn::Neg(y.x)), hn::IfThenElse(y.known, y.y, x.x)};
}

/// The parts of J = U diag(sigma) V^T in use.
struct Decomposition {
  HWY_INLINE explicit Decomposition(const Jacobian& j) {
    const Floats d;
    const FloatVec half = hn::Set(d, 0.5F);
    const FloatVec p = hn::MulAdd(j.a, j.a, hn::Mul(j.b, j.b));
    const FloatVec r = hn::MulAdd(j.c, j.c, hn::Mul(j.d, j.d));
    const FloatVec q = hn::MulAdd(j.a, j.c, hn::Mul(j.b, j.d));
    const FloatVec difference = hn::Sub(p, r);
    const FloatVec twice = hn::Add(q, q);
    const FloatVec root = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(twice, twice)));
    const auto round = hn::Eq(root, hn::Zero(d));
    const FloatVec cos = hn::IfThenElse(round, hn::Set(d, 1.0F), hn::Div(difference, root));
    const FloatVec sin = hn::IfThenZeroElse(round, hn::Div(twice, root));
    det = hn::Sub(hn::Mul(j.a, j.d), hn::Mul(j.b, j.c));
    larger = hn::Sqrt(hn::Mul(hn::Add(hn::Add(p, r), root), half));
    smaller = hn::Div(hn::Abs(det), larger);
    xx = hn::MulAdd(cos, half, half);
    yy = hn::NegMulAdd(cos, half, half);
    xy = hn::Mul(sin, half);
  }

  FloatVec det, larger, smaller;  ///< determinant of J, singular values
  FloatVec xx, xy, yy;            ///< the projection P1 on the first column of U; P2 = 1 - P1 projects on the second
};

/// The rows of the inverse of J with its singular values clamped to [1, most]:
/// J^T P1 / (sigma1 held1) + sign(det J) adj(J) P2 / (sigma1 held2), which needs no division by sigma2.
HWY_INLINE void invert(const Jacobian& j, const Decomposition& s, float most, size_t i, Footprints& footprints) {
  const Floats d;
  const FloatVec one = hn::Set(d, 1.0F);
  const auto held = [&](FloatVec sigma) { return hn::Min(hn::Max(sigma, one), hn::Set(d, most)); };
  const FloatVec first = hn::Div(one, hn::Mul(s.larger, held(s.larger)));
  const FloatVec second = hn::CopySign(hn::Div(one, hn::Mul(s.larger, held(s.smaller))), s.det);
  const auto row = [&](FloatVec x1, FloatVec y1, FloatVec x2, FloatVec y2, float* x, float* y) {
    const FloatVec x_first = hn::MulAdd(x1, s.xx, hn::Mul(y1, s.xy));
    const FloatVec y_first = hn::MulAdd(x1, s.xy, hn::Mul(y1, s.yy));
    const FloatVec x_second = hn::Sub(hn::Mul(x2, s.yy), hn::Mul(y2, s.xy));
    const FloatVec y_second = hn::Sub(hn::Mul(y2, s.xx), hn::Mul(x2, s.xy));
    hn::Store(hn::MulAdd(x_first, first, hn::Mul(x_second, second)), d, x + i);
    hn::Store(hn::MulAdd(y_first, first, hn::Mul(y_second, second)), d, y + i);
  };
  row(j.a, j.c, j.d, hn::Neg(j.b), footprints.ux, footprints.uy);
  row(j.b, j.d, hn::Neg(j.c), j.a, footprints.vx, footprints.vy);
}

/// Makes a row of the inverse a normal of length 1, and computes the extent of the slab on either side.
HWY_INLINE void make_slab(float* x, float* y, float* half, float* reach) {
  const Floats d;
  const FloatVec row_x = hn::Load(d, x);
  const FloatVec row_y = hn::Load(d, y);
  const FloatVec square = hn::Div(hn::Set(d, 1.0F), hn::MulAdd(row_x, row_x, hn::Mul(row_y, row_y)));
  const FloatVec pixels = hn::Sqrt(square);
  const FloatVec width = hn::Mul(hn::Sqrt(hn::Sub(square, hn::Set(d, kOwnSquare))), hn::Set(d, 0.5F));
  hn::Store(hn::Mul(row_x, pixels), d, x);
  hn::Store(hn::Mul(row_y, pixels), d, y);
  hn::Store(width, d, half);
  hn::Store(hn::Add(width, hn::Set(d, 2.0F)), d, reach);
}

/// The box around { |u| < u_reach, |v| < v_reach }.
HWY_INLINE void bound(size_t i, Footprints& f) {
  const Floats d;
  const auto load = [&](const float* from) { return hn::Load(d, from + i); };
  const FloatVec det = hn::Sub(hn::Mul(load(f.ux), load(f.vy)), hn::Mul(load(f.uy), load(f.vx)));
  const FloatVec inverse = hn::Div(hn::Set(d, 1.0F), hn::Abs(det));
  const auto reach = [&](const float* u, const float* v) {
    const FloatVec sum = hn::MulAdd(hn::Abs(load(v)), load(f.u_reach), hn::Mul(hn::Abs(load(u)), load(f.v_reach)));
    return hn::Mul(sum, inverse);
  };
  hn::Store(reach(f.uy, f.vy), d, f.x_reach + i);
  hn::Store(reach(f.ux, f.vx), d, f.y_reach + i);
}

/// From 0 at `begin` to 1 at `end`.
HWY_INLINE FloatVec ramp(FloatVec value, float begin, float end) {
  const Floats d;
  const FloatVec way = hn::Mul(hn::Sub(value, hn::Set(d, begin)), hn::Set(d, 1.0F / (end - begin)));
  const FloatVec held = hn::Min(hn::Max(way, hn::Zero(d)), hn::Set(d, 1.0F));
  return hn::Mul(hn::Mul(held, held), hn::NegMulAdd(hn::Set(d, 2.0F), held, hn::Set(d, 3.0F)));
}

/// The sums of a block. For pixels without a sum only `blend` is set.
/// @param blend  for the vector of pixels that begins at the block's i-th: 0 no sum, 1 a sum only.
template <typename Filter>
HWY_INLINE void make_footprints(const Jacobian& j, const Decomposition& shape, FloatVec blend, size_t i,
                                Footprints& footprints) {
  const Floats d;
  hn::Store(blend, d, footprints.blend + i);
  if (hn::AllFalse(d, hn::Gt(blend, hn::Zero(d)))) return;
  invert(j, shape, Filter::kMostStretch, i, footprints);
  if constexpr (Filter::kIsSlab) {
    make_slab(footprints.ux + i, footprints.uy + i, footprints.u_half + i, footprints.u_reach + i);
    make_slab(footprints.vx + i, footprints.vy + i, footprints.v_half + i, footprints.v_reach + i);
  } else {
    const FloatVec reach = hn::Set(d, Filter::kReach);
    hn::Store(reach, d, footprints.u_reach + i);
    hn::Store(reach, d, footprints.v_reach + i);
  }
  bound(i, footprints);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
