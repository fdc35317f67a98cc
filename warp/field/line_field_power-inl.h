// Powers for the weights of the line field. Included once per instruction set; the guard toggles accordingly.
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

/// 2^(scale + power log2(z)) for normal z > 0, within a few units of roundoff for any exponent: its large part,
/// integers times 8 bits, is kept apart from the small one. Results below 2^-126 are 0.
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

/// log2(z) for normal z > 0, within 1e-7 plus the rounding of one sum. The polynomial agrees with log2(m) / (m - 1) at
/// eight Chebyshev nodes; its terms are summed as a tree, for speed.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quick_log2(D d, V z) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, z);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3F3504F3)));  // against sqrt(1/2)
  const V t = hn::Sub(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent))), hn::Set(d, 1.0f));
  const V t2 = hn::Mul(t, t);
  const V c01 = hn::MulAdd(t, hn::Set(d, -0.7213529313629747f), hn::Set(d, 1.4426949948930465f));
  const V c23 = hn::MulAdd(t, hn::Set(d, -0.36022518246097257f), hn::Set(d, 0.480916708000218f));
  const V c45 = hn::MulAdd(t, hn::Set(d, -0.24927182207504475f), hn::Set(d, 0.2872888823739538f));
  const V c67 = hn::MulAdd(t, hn::Set(d, -0.1427597343597421f), hn::Set(d, 0.23265257882137133f));
  const V low = hn::MulAdd(t2, c23, c01);
  const V high = hn::MulAdd(t2, c67, c45);
  return hn::MulAdd(t, hn::MulAdd(hn::Mul(t2, t2), high, low), hn::ConvertTo(d, exponent));
}

/// 2^f for f in [-1/2, 1/2], likewise at six nodes; relative error below 1.1e-7 before rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quick_exp2_fraction(D d, V f) {
  const V f2 = hn::Mul(f, f);
  const V c01 = hn::MulAdd(f, hn::Set(d, 0.6931471880262282f), hn::Set(d, 1.0000000754548972f));
  const V c23 = hn::MulAdd(f, hn::Set(d, 0.05550357114220131f), hn::Set(d, 0.24022107485308314f));
  const V c45 = hn::MulAdd(f, hn::Set(d, 0.0013390863364344022f), hn::Set(d, 0.009676031918323188f));
  return hn::MulAdd(f2, hn::MulAdd(f2, c45, c23), c01);
}

/// 2^(scale + power log2(z)) for normal z > 0 and results below 2^127, within kQuickPowerUnits units of roundoff for
/// exponents in [-100, 100]. Results below 2^-125 are 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quick_power(D d, V z, V power, V scale) {
  const hn::RebindToSigned<D> di;
  const V exponent = hn::MulAdd(power, quick_log2(d, z), scale);
  const V whole = hn::Round(exponent);
  const V result = quick_exp2_fraction(d, hn::Sub(exponent, whole));
  const auto scaled = hn::Add(hn::BitCast(di, result), hn::ShiftLeft<23>(hn::ConvertTo(di, whole)));
  return hn::IfThenElseZero(hn::Ge(exponent, hn::Set(d, -125.0f)), hn::BitCast(d, scaled));
}
/// The exponent is rounded three times. With log2(z) at most 30 and the exponent at most 100, that is at most 160
/// units, which act on the result times ln 2. The polynomials add 12.
constexpr double kQuickPowerUnits = 125;

/// Whether the machine estimates 1 / z and 1 / sqrt(z) with an error of at most 1.5 2^-12, as x86 does. One Newton step
/// reduces it to 2^-22 at worst, and costs less than a division or a root.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
constexpr bool kHasEstimates = true;
#else
constexpr bool kHasEstimates = false;
#endif

/// 1 / z for z within [2^-120, 2^120], within 4 units of roundoff.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quick_reciprocal(D d, V z) {
  if constexpr (!kHasEstimates) return hn::Div(hn::Set(d, 1.0f), z);
  const V estimate = hn::ApproximateReciprocal(z);
  return hn::MulAdd(estimate, hn::NegMulAdd(z, estimate, hn::Set(d, 1.0f)), estimate);
}

/// a + 2 sqrt(z) for z within [2^-100, 2^120] and a >= 0, within 6 units of roundoff. The Newton step from an estimate
/// e of 1 / sqrt(z), with t = z e, is t (3 - t e) / 2. Leaving the half to the caller saves a multiplication.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V plus_twice_root(D d, V z, V a) {
  if constexpr (!kHasEstimates) {
    const V root = hn::Sqrt(z);
    return hn::Add(a, hn::Add(root, root));
  } else {
    const V estimate = hn::ApproximateReciprocalSqrt(z);
    const V root = hn::Mul(z, estimate);
    return hn::MulAdd(root, hn::NegMulAdd(root, estimate, hn::Set(d, 3.0f)), a);
  }
}

/// z^-2 likewise, within 8 units: y^2 (3 - 2 z y) from an estimate y of 1 / z.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quick_inverse_square(D d, V z) {
  if constexpr (!kHasEstimates) {
    const V inverse = hn::Div(hn::Set(d, 1.0f), z);
    return hn::Mul(inverse, inverse);
  } else {
    const V estimate = hn::ApproximateReciprocal(z);
    const V step = hn::NegMulAdd(z, hn::Add(estimate, estimate), hn::Set(d, 3.0f));
    return hn::Mul(hn::Mul(estimate, estimate), step);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
