// The kernel behind mix_row.

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "base/kernel_targets.h"
#include "warp/image/mix.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/image/mix_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void run_mix(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) {
  reference_mix_row(a, b, alpha);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D> >
HWY_INLINE V mixed(D d, V a, V b, V weight) {
  return hn::Add(hn::Mul(hn::Sub(hn::Set(d, 1.0F), weight), a), hn::Mul(weight, b));
}

void mix_evenly(float* a, const float* b, size_t count, float weight) {
  const hn::CappedTag<float, 16> d;
  const auto weights = hn::Set(d, weight);
  size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    hn::StoreU(mixed(d, hn::LoadU(d, a + i), hn::LoadU(d, b + i), weights), d, a + i);
  }
  const hn::FixedTag<float, 4> pixel;
  for (; i < count; i += 4) {
    hn::StoreU(mixed(pixel, hn::LoadU(pixel, a + i), hn::LoadU(pixel, b + i), hn::Set(pixel, weight)), pixel, a + i);
  }
}

void mix_each(float* a, const float* b, std::span<const float> alpha) {
  const hn::FixedTag<float, 4> d;
  for (size_t i = 0; i < alpha.size(); ++i) {
    const auto first = hn::LoadU(d, a + 4 * i);
    const auto second = hn::LoadU(d, b + 4 * i);
    const auto weight = hn::Set(d, alpha[i]);
    const auto inner = hn::IfThenElse(hn::Le(weight, hn::Zero(d)), first, mixed(d, first, second, weight));
    hn::StoreU(hn::IfThenElse(hn::Ge(weight, hn::Set(d, 1.0F)), second, inner), d, a + 4 * i);
  }
}

void run_mix(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) {
  if (alpha.size() != 1) return mix_each(a.data()->val, b.data()->val, alpha);
  const float weight = alpha.front();
  if (weight <= 0) return;
  if (weight >= 1) {
    std::copy(b.begin(), b.end(), a.begin());
    return;
  }
  mix_evenly(a.data()->val, b.data()->val, 4 * a.size(), weight);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp {
namespace detail {
HWY_EXPORT(run_mix);
}

void mix_row(std::span<Pixel> a, std::span<const Pixel> b, std::span<const float> alpha) noexcept {
  assert(a.size() == b.size());
  assert(alpha.size() == 1 || alpha.size() == a.size());
  if (!a.empty()) HWY_DYNAMIC_DISPATCH(detail::run_mix)(a, b, alpha);
}

}  // namespace morphkit::warp
#endif  // HWY_ONCE
