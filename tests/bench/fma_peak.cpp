#include "tests/bench/fma_peak.h"

#include <benchmark/benchmark.h>

#include "base/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/fma_peak.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

std::int64_t fma_rounds(std::int64_t rounds) {
  const hn::ScalableTag<float> d;
  const auto factor = hn::Set(d, 0.9999f), term = hn::Set(d, 0.0001f);
  // Enough chains to hide the latency of one: 4 cycles, two at once, and some to spare. Each begins with a different
  // number, or the compiler would see that all are the same.
  const auto start = [d](float value) {
    benchmark::DoNotOptimize(value);
    return hn::Set(d, value);
  };
  auto a = start(1), b = start(2), c = start(3), e = start(4), f = start(5);
  auto g = start(6), h = start(7), i = start(8), j = start(9), k = start(10);
  for (std::int64_t round = 0; round < rounds; ++round) {
    a = hn::MulAdd(a, factor, term);
    b = hn::MulAdd(b, factor, term);
    c = hn::MulAdd(c, factor, term);
    e = hn::MulAdd(e, factor, term);
    f = hn::MulAdd(f, factor, term);
    g = hn::MulAdd(g, factor, term);
    h = hn::MulAdd(h, factor, term);
    i = hn::MulAdd(i, factor, term);
    j = hn::MulAdd(j, factor, term);
    k = hn::MulAdd(k, factor, term);
  }
  const auto sum =
      hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)), hn::Add(hn::Add(f, g), hn::Add(h, hn::Add(i, hn::Add(j, k)))));
  benchmark::DoNotOptimize(hn::GetLane(hn::SumOfLanes(d, sum)));
  constexpr std::int64_t kChains = 10, kOperations = 2;
  return rounds * kChains * kOperations * static_cast<std::int64_t>(hn::Lanes(d));
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp {

HWY_EXPORT(fma_rounds);

std::int64_t run_fma(std::int64_t rounds) {
  return HWY_DYNAMIC_DISPATCH(fma_rounds)(rounds);
}

}  // namespace morphkit::warp
#endif  // HWY_ONCE
