// The kernel behind LineKnots::edges: a cubic per segment, in double lanes over output pixel edges. No fused
// multiply-adds, so every instruction set gives the same bits.

#include <cstddef>
#include <span>

#include "base/kernel_targets.h"
#include "warp/mesh/mesh_curves.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/mesh/mesh_edges_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using DoubleVec = hn::Vec<Doubles>;

/// One segment, from edge k to edge `end`; vectors may write beyond `end`, but not beyond `edges`.
class Segment {
 public:
  HWY_INLINE Segment(const LineKnots& knots, const LineKnots::Cubic& cubic, size_t i)
      : to_(hn::Set(d_, knots.to[i])),
        inverse_width_(hn::Set(d_, cubic.inverse_width)),
        c0_(hn::Set(d_, cubic.c0)),
        c1_(hn::Set(d_, cubic.c1)),
        c2_(hn::Set(d_, cubic.c2)),
        c3_(hn::Set(d_, cubic.c3)),
        least_(hn::Set(d_, knots.from[i])),
        most_(hn::Set(d_, knots.from[i + 1])) {}

  HWY_INLINE DoubleVec at(DoubleVec x) const {
    const DoubleVec u = hn::Mul(hn::Sub(x, to_), inverse_width_);
    DoubleVec moved = hn::Add(c2_, hn::Mul(u, c3_));
    moved = hn::Add(c1_, hn::Mul(u, moved));
    moved = hn::Add(c0_, hn::Mul(u, moved));
    return hn::Min(hn::Max(hn::Add(x, moved), least_), most_);
  }

 private:
  Doubles d_;
  DoubleVec to_, inverse_width_, c0_, c1_, c2_, c3_, least_, most_;
};

void fill(const LineKnots& knots, std::span<const LineKnots::Cubic> cubics, std::span<double> edges) {
  const Doubles d;
  const size_t lanes = hn::Lanes(d), n = edges.size();
  size_t k = whole_from(knots.to.front(), n);
  for (size_t i = 0; i < cubics.size(); ++i) {
    const size_t end = whole_from(knots.to[i + 1], n);
    if (end <= k) continue;
    const Segment segment(knots, cubics[i], i);
    DoubleVec x = hn::Iota(d, static_cast<double>(k));
    const DoubleVec step = hn::Set(d, static_cast<double>(lanes));
    for (; k < end; k += lanes, x = hn::Add(x, step)) {
      if (k + lanes <= n) {
        hn::StoreU(segment.at(x), d, edges.data() + k);
        continue;
      }
      HWY_ALIGN double last[hn::MaxLanes(Doubles())];
      hn::Store(segment.at(x), d, last);
      for (size_t j = k; j < end; ++j) edges[j] = last[j - k];
    }
    k = end;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp {
namespace detail {
HWY_EXPORT(fill);
}

void fill_edges(const LineKnots& knots, std::span<const LineKnots::Cubic> cubics, std::span<double> edges) noexcept {
  HWY_DYNAMIC_DISPATCH(detail::fill)(knots, cubics, edges);
}

}  // namespace morphkit::warp
#endif  // HWY_ONCE
