// The kernels of the antialiasing filters in vectors. Included by antialias_simd.cpp once per instruction set.

#if defined(MORPHKIT_WARP_SAMPLE_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_SAMPLE_FILTERS_INL_H_
#undef MORPHKIT_WARP_SAMPLE_FILTERS_INL_H_
#else
#define MORPHKIT_WARP_SAMPLE_FILTERS_INL_H_
#endif

#include "hwy/highway.h"
#include "warp/sample/antialias_footprint-inl.h"
#include "warp/sample/filters.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The integral of the Catmull-Rom kernel from 0 to d.
HWY_INLINE FloatVec catmull_rom_integral(FloatVec d) {
  const Floats tag;
  const FloatVec a = hn::Min(hn::Abs(d), hn::Set(tag, 2.0F));
  const FloatVec rest = hn::Sub(hn::Set(tag, 2.0F), a);
  const FloatVec inside =
      hn::MulAdd(hn::Mul(a, hn::Mul(a, a)), hn::MulAdd(a, hn::Set(tag, 0.375F), hn::Set(tag, -5.0F / 6)), a);
  const FloatVec outside =
      hn::MulAdd(hn::Mul(rest, hn::Mul(rest, rest)), hn::MulAdd(rest, hn::Set(tag, -0.125F), hn::Set(tag, 1.0F / 6)),
                 hn::Set(tag, 0.5F));
  return hn::CopySign(hn::IfThenElse(hn::Lt(a, hn::Set(tag, 1.0F)), inside, outside), d);
}

/// The weight at coordinate `u` of a footprint's axis. @param half  half the width of the box.
HWY_INLINE FloatVec axis_weight(AreaFilter, FloatVec u, FloatVec half) {
  return hn::Sub(catmull_rom_integral(hn::Add(u, half)), catmull_rom_integral(hn::Sub(u, half)));
}

HWY_INLINE FloatVec axis_weight(MitchellFilter, FloatVec x, FloatVec) {
  const Floats tag;
  const FloatVec a = hn::Min(hn::Abs(x), hn::Set(tag, 2.0F));
  const FloatVec rest = hn::Sub(hn::Set(tag, 2.0F), a);
  const FloatVec inside =
      hn::MulAdd(hn::Mul(a, a), hn::MulAdd(a, hn::Set(tag, 7.0F / 6), hn::Set(tag, -2.0F)), hn::Set(tag, 8.0F / 9));
  const FloatVec outside =
      hn::Mul(hn::Mul(rest, rest), hn::MulAdd(rest, hn::Set(tag, 7.0F / 18), hn::Set(tag, -1.0F / 3)));
  return hn::IfThenElse(hn::Lt(a, hn::Set(tag, 1.0F)), inside, outside);
}

/// sinc(x) sinc(x / 3): a factor for its zeros, times the polynomial in z = x^2 that agrees with the other factor at
/// the seven Chebyshev nodes of [0, 9]. The error is below 9e-6 before rounding.
HWY_INLINE FloatVec axis_weight(LanczosFilter, FloatVec x, FloatVec) {
  const Floats tag;
  const FloatVec one = hn::Set(tag, 1.0F);
  const FloatVec z = hn::Min(hn::Mul(x, x), hn::Set(tag, 9.0F));
  FloatVec rest = hn::Set(tag, 3.5277119536658574e-07F);
  rest = hn::MulAdd(rest, z, hn::Set(tag, -1.7292044503847137e-05F));
  rest = hn::MulAdd(rest, z, hn::Set(tag, 0.0004050587594974786F));
  rest = hn::MulAdd(rest, z, hn::Set(tag, -0.005981256254017353F));
  rest = hn::MulAdd(rest, z, hn::Set(tag, 0.05876343324780464F));
  rest = hn::MulAdd(rest, z, hn::Set(tag, -0.35538625717163086F));
  rest = hn::MulAdd(rest, z, hn::Set(tag, 0.9999911785125732F));
  const FloatVec third = hn::NegMulAdd(z, hn::Set(tag, 1.0F / 9), one);
  const FloatVec zeros =
      hn::Mul(hn::Mul(hn::Sub(one, z), hn::NegMulAdd(z, hn::Set(tag, 0.25F), one)), hn::Mul(third, third));
  return hn::Mul(zeros, rest);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
