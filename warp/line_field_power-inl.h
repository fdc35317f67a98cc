// Powers for the weights of the line field, on the instruction set that is being compiled. Included once for each by
// warp/line_field_simd.cpp; the guard toggles accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_POWER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_POWER_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_POWER_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_POWER_INL_H_
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A number as the sum of two floats.
template <class V>
struct SplitVector {
  V hi, lo;
};

/// log2(m) for m in [sqrt(1/2), sqrt(2)): (m - 1) times the polynomial that agrees with log2(m) / (m - 1) at the nine
/// Chebyshev nodes of the interval; relative error below 3e-8 before rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log2_mantissa(D d, V m) {
  const V t = hn::Sub(m, hn::Set(d, 1.0f));
  V poly = hn::Set(d, 0.12310968466640239f);
  poly = hn::MulAdd(poly, t, hn::Set(d, -0.2058618805104845f));
  poly = hn::MulAdd(poly, t, hn::Set(d, 0.21607822552354497f));
  poly = hn::MulAdd(poly, t, hn::Set(d, -0.23916988140163079f));
  poly = hn::MulAdd(poly, t, hn::Set(d, 0.2879032609244332f));
  poly = hn::MulAdd(poly, t, hn::Set(d, -0.3606932681352889f));
  poly = hn::MulAdd(poly, t, hn::Set(d, 0.48091075345941564f));
  poly = hn::MulAdd(poly, t, hn::Set(d, -0.7213474682495639f));
  poly = hn::MulAdd(poly, t, hn::Set(d, 1.442695003567982f));
  return hn::Mul(poly, t);
}

/// 2^f for f in [-1/2, 1/2], likewise; relative error below 6e-9 before rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exp2_fraction(D d, V f) {
  V poly = hn::Set(d, 0.00015453162941960995f);
  poly = hn::MulAdd(poly, f, hn::Set(d, 0.0013390863364651736f));
  poly = hn::MulAdd(poly, f, hn::Set(d, 0.009618082557286533f));
  poly = hn::MulAdd(poly, f, hn::Set(d, 0.055503571142191135f));
  poly = hn::MulAdd(poly, f, hn::Set(d, 0.24022650760568082f));
  poly = hn::MulAdd(poly, f, hn::Set(d, 0.6931471880262287f));
  return hn::MulAdd(poly, f, hn::Set(d, 1.0f));
}

/// 2^(scale + power log2(z)) for normal z > 0, within a few units of roundoff whatever the size of the exponent: its
/// large part, integers times 8 bits, is kept apart from the small one. Below 2^-126 it is 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scaled_power(D d, V z, SplitVector<V> power, SplitVector<V> scale) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, z);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3F3504F3)));  // against sqrt(1/2)
  const V mantissa = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const V e = hn::ConvertTo(d, exponent);
  const V large = hn::MulAdd(power.hi, e, scale.hi);  // exact
  const V small =
      hn::MulAdd(hn::Add(power.hi, power.lo), log2_mantissa(d, mantissa), hn::MulAdd(power.lo, e, scale.lo));
  const V whole = hn::Round(hn::Add(large, small));
  const V fraction = hn::Add(hn::Sub(large, whole), small);
  const V clamped = hn::Min(hn::Max(whole, hn::Set(d, -126.0f)), hn::Set(d, 126.0f));
  const auto two_to = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, clamped), hn::Set(di, 127)));
  const V result = hn::Mul(exp2_fraction(d, fraction), hn::BitCast(d, two_to));
  return hn::IfThenElseZero(hn::Ge(whole, hn::Set(d, -126.0f)), result);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
