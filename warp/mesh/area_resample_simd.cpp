// The kernel behind resample_line: the weights of a block of output pixels in double lanes over pixels, then every
// pixel as a weighted sum in float lanes over channels.
//
// What keeps float arithmetic close to the double reference:
//  - A piece of an interval is a polynomial in its position within the source pixel, as a product of u and 1 - u, so
//    that short pieces keep their relative precision. No value is the difference of two running sums of a line.
//  - The mean is written as "the first pixel plus weighted differences from it": a constant stays the same to the bit,
//    so an opaque image stays opaque.
//  - Long runs of whole pixels are summed pairwise.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/kernel_targets.h"
#include "warp/mesh/area_resample_line.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/mesh/area_resample_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Output pixels with weights computed together. Half as many would be 10 % slower.
constexpr size_t kBlock = 32;

/// The weights of a block's pixels, relative to the first pixel r of their intervals. The mean of a channel is
///   r + before (p[first - 1] - r) + after (p[first + 1] - r) + beyond (p[first + 2] - r) + far (p[first + 3] - r)
/// if the interval ends in the pixel where it begins or in one of the next two, and otherwise
///   r + before (p[first - 1] - r) + tail_after (p[first + 1] - r) + inverse sum (p[first + 1 .. last - 1] - r)
///     + head_before (p[last - 1] - r) + head_at (p[last] - r) + head_beyond (p[last + 1] - r).
struct Weights {
  alignas(64) float before[kBlock], after[kBlock], beyond[kBlock], far[kBlock];
  alignas(64) float tail_after[kBlock], head_before[kBlock], head_at[kBlock], head_beyond[kBlock], inverse[kBlock];
  alignas(64) int32_t first[kBlock], last[kBlock];
};

/// Properties of all intervals of a block.
struct Shape {
  bool all_whole = true;  ///< each is one whole source pixel
  bool any_whole = false;
  ptrdiff_t lowest = 0, highest = 0;  ///< source pixels in use
  int longest = 1;                    ///< the most pixels after an interval's first: 1 for none or one, 2, 3 for more
};

using Doubles = hn::CappedTag<double, 8>;
using DoubleVec = hn::Vec<Doubles>;

/// Several values of warp::Interval.
struct Intervals {
  DoubleVec first, last, begin, end, length;
};

HWY_INLINE Intervals intervals_of(const double* edges, size_t source_pixels) {
  const Doubles d;
  DoubleVec a = hn::LoadU(d, edges);
  DoubleVec b = hn::LoadU(d, edges + 1);
  const DoubleVec shortest = hn::Set(d, kShortestIntervalPx);
  const auto too_short = hn::Lt(hn::Sub(b, a), shortest);
  if (!hn::AllFalse(d, too_short)) {
    const DoubleVec half = hn::Set(d, 0.5);
    const DoubleVec centred = hn::Sub(hn::Mul(hn::Add(a, b), half), hn::Mul(shortest, half));
    const DoubleVec highest = hn::Set(d, static_cast<double>(source_pixels) - kShortestIntervalPx);
    a = hn::IfThenElse(too_short, hn::Min(hn::Max(centred, hn::Zero(d)), highest), a);
    b = hn::IfThenElse(too_short, hn::Add(a, shortest), b);
  }
  const DoubleVec first = hn::Floor(a);
  const DoubleVec last = hn::Sub(hn::Ceil(b), hn::Set(d, 1.0));
  return {first, last, hn::Sub(a, first), hn::Sub(b, last), hn::Sub(b, a)};
}

/// The Hermite weights of the slopes, halved because a slope is half a difference of pixels, at u: u (1 - u)^2 / 2 and
/// u^2 (u - 1) / 2.
struct Hermite {
  HWY_INLINE explicit Hermite(DoubleVec u) {
    const Doubles d;
    const DoubleVec rest = hn::Sub(hn::Set(d, 1.0), u);
    const DoubleVec both = hn::Mul(hn::Mul(u, rest), hn::Set(d, 0.5));
    left = hn::Mul(both, rest);
    right = hn::Neg(hn::Mul(both, u));
  }
  DoubleVec left, right;
};

HWY_INLINE void store_float(DoubleVec value, float* to) {
  const hn::Rebind<float, Doubles> df;
  hn::Store(hn::DemoteTo(df, value), df, to);
}

HWY_INLINE void store_int(DoubleVec value, int32_t* to) {
  const hn::Rebind<int32_t, Doubles> di;
  hn::Store(hn::DemoteTo(di, value), di, to);
}

Shape weigh(const double* edges, size_t source_pixels, Weights& weights) {
  const Doubles d;
  const DoubleVec one = hn::Set(d, 1.0);
  Shape shape;
  DoubleVec least = hn::Set(d, static_cast<double>(source_pixels)), most = hn::Zero(d);
  for (size_t k = 0; k < kBlock; k += hn::Lanes(d)) {
    const Intervals in = intervals_of(edges + k, source_pixels);
    least = hn::Min(least, in.first);
    most = hn::Max(most, hn::Max(in.last, hn::Add(in.first, hn::Set(d, 2.0))));
    const auto within_one = hn::Eq(in.first, in.last);
    const auto whole = hn::And(within_one, hn::And(hn::Eq(in.begin, hn::Zero(d)), hn::Eq(in.end, one)));
    shape.all_whole = shape.all_whole && hn::AllTrue(d, whole);
    shape.any_whole = shape.any_whole || !hn::AllFalse(d, whole);
    const DoubleVec steps = hn::Sub(in.last, in.first);
    const DoubleVec inverse = hn::Div(one, in.length);
    const Hermite begin(in.begin);
    const Hermite end(in.end);
    const DoubleVec before = hn::Sub(hn::IfThenElseZero(within_one, end.left), begin.left);
    const DoubleVec tail_after = hn::Neg(hn::Mul(begin.right, inverse));
    const DoubleVec head_at = hn::Sub(in.end, hn::Add(end.left, end.right));
    const DoubleVec head_beyond = hn::Mul(end.right, inverse);
    const DoubleVec after = hn::MulAdd(hn::IfThenElse(within_one, end.right, head_at), inverse, tail_after);
    store_float(hn::Mul(before, inverse), weights.before + k);
    store_float(after, weights.after + k);
    const DoubleVec beyond = hn::IfThenZeroElse(within_one, head_beyond);
    store_float(beyond, weights.beyond + k);
    store_int(in.first, weights.first + k);
    store_int(in.last, weights.last + k);
    store_float(hn::Zero(d), weights.far + k);
    if (hn::AllFalse(d, hn::Gt(steps, one))) continue;
    const DoubleVec head_before = hn::Mul(end.left, inverse);
    const auto two = hn::Eq(steps, hn::Set(d, 2.0));
    const DoubleVec between = hn::Add(tail_after, hn::Add(inverse, head_before));
    store_float(hn::IfThenElse(two, between, after), weights.after + k);
    store_float(hn::IfThenElse(two, hn::Mul(head_at, inverse), beyond), weights.beyond + k);
    store_float(hn::IfThenElseZero(two, head_beyond), weights.far + k);
    shape.longest = std::max(shape.longest, 2);
    if (hn::AllFalse(d, hn::Gt(steps, hn::Set(d, 2.0)))) continue;
    shape.longest = 3;
    store_float(tail_after, weights.tail_after + k);
    store_float(head_before, weights.head_before + k);
    store_float(hn::Mul(head_at, inverse), weights.head_at + k);
    store_float(head_beyond, weights.head_beyond + k);
    store_float(inverse, weights.inverse + k);
  }
  shape.lowest = static_cast<ptrdiff_t>(hn::GetLane(hn::MinOfLanes(d, least))) - 1;
  shape.highest = static_cast<ptrdiff_t>(hn::GetLane(hn::MaxOfLanes(d, most))) + 1;
  return shape;
}

// ---- Per pixel, in float lanes over channels.

using Floats = hn::CappedTag<float, 4>;
using FloatVec = hn::Vec<Floats>;

/// One channel group of a source line; kSafe: indices beyond the ends occur and give the pixel at the end.
template <bool kSafe>
class Channels {
 public:
  Channels(std::span<const Pixel> source, size_t channel)
      : values_(source.data()->val + channel), last_(static_cast<ptrdiff_t>(source.size()) - 1) {}

  HWY_INLINE FloatVec at(ptrdiff_t i) const {
    if constexpr (kSafe) i = std::clamp<ptrdiff_t>(i, 0, last_);
    return hn::LoadU(Floats(), values_ + 4 * i);
  }

 private:
  const float* values_;
  ptrdiff_t last_;
};

/// Adds weight * (value - from) to sum.
HWY_INLINE FloatVec add_weighted(FloatVec sum, float weight, FloatVec value, FloatVec from) {
  return hn::MulAdd(hn::Set(Floats(), weight), hn::Sub(value, from), sum);
}

/// kSteps: 1 or 2, the pixels that the interval may go beyond its first.
template <int kSteps, bool kSafe>
HWY_INLINE FloatVec short_mean(const Channels<kSafe>& source, const Weights& weights, size_t k) {
  const ptrdiff_t first = weights.first[k];
  const FloatVec from = source.at(first);
  FloatVec sum = hn::Mul(hn::Set(Floats(), weights.beyond[k]), hn::Sub(source.at(first + 2), from));
  if constexpr (kSteps == 2) sum = add_weighted(sum, weights.far[k], source.at(first + 3), from);
  sum = add_weighted(sum, weights.before[k], source.at(first - 1), from);
  sum = add_weighted(sum, weights.after[k], source.at(first + 1), from);
  return hn::Add(from, sum);
}

/// The sum of `count` pixels' differences from `from`. Rounding errors grow with the number of consecutive additions,
/// so a sum of more than a few dozen is split in half.
template <class Source>
FloatVec sum_of(const Source& source, ptrdiff_t begin, ptrdiff_t count, FloatVec from) {
  constexpr ptrdiff_t kInARow = 64;
  if (count > kInARow) {
    const ptrdiff_t half = count / 2;
    return hn::Add(sum_of(source, begin, half, from), sum_of(source, begin + half, count - half, from));
  }
  FloatVec even = hn::Zero(Floats());
  FloatVec odd = hn::Zero(Floats());
  ptrdiff_t i = 0;
  for (; i + 1 < count; i += 2) {
    even = hn::Add(even, hn::Sub(source.at(begin + i), from));
    odd = hn::Add(odd, hn::Sub(source.at(begin + i + 1), from));
  }
  if (i < count) even = hn::Add(even, hn::Sub(source.at(begin + i), from));
  return hn::Add(even, odd);
}

template <bool kSafe>
HWY_INLINE FloatVec long_mean(const Channels<kSafe>& source, const Weights& weights, size_t k) {
  const ptrdiff_t first = weights.first[k];
  const ptrdiff_t last = weights.last[k];
  const FloatVec from = source.at(first);
  FloatVec sum = hn::Mul(hn::Set(Floats(), weights.inverse[k]), sum_of(source, first + 1, last - first - 1, from));
  sum = add_weighted(sum, weights.head_beyond[k], source.at(last + 1), from);
  sum = add_weighted(sum, weights.before[k], source.at(first - 1), from);
  sum = add_weighted(sum, weights.tail_after[k], source.at(first + 1), from);
  sum = add_weighted(sum, weights.head_before[k], source.at(last - 1), from);
  sum = add_weighted(sum, weights.head_at[k], source.at(last), from);
  return hn::Add(from, sum);
}

/// See finish() of the reference.
HWY_INLINE void finish(FloatVec value, float* out, size_t channel) {
  constexpr float kMax = std::numeric_limits<float>::max();
  alignas(16) constexpr float kLower[4] = {-kMax, -kMax, -kMax, 0.0F};
  alignas(16) constexpr float kUpper[4] = {kMax, kMax, kMax, 1.0F};
  const Floats d;
  const FloatVec lower = hn::Load(d, kLower + channel);
  value = hn::IfThenElse(hn::Gt(value, lower), value, lower);  // lower for NaN
  hn::StoreU(hn::Min(value, hn::Load(d, kUpper + channel)), d, out + channel);
}

template <int kSteps, bool kSafe>
void short_block(std::span<const Pixel> source, const Weights& weights, std::span<Pixel> out) {
  for (size_t channel = 0; channel < 4; channel += hn::Lanes(Floats())) {
    const Channels<kSafe> channels(source, channel);
    for (size_t k = 0; k < out.size(); ++k) finish(short_mean<kSteps>(channels, weights, k), out[k].val, channel);
  }
}

template <bool kSafe>
void mixed_block(std::span<const Pixel> source, const Weights& weights, std::span<Pixel> out) {
  for (size_t channel = 0; channel < 4; channel += hn::Lanes(Floats())) {
    const Channels<kSafe> channels(source, channel);
    for (size_t k = 0; k < out.size(); ++k) {
      const bool is_long = weights.last[k] - weights.first[k] > 2;
      finish(is_long ? long_mean(channels, weights, k) : short_mean<2>(channels, weights, k), out[k].val, channel);
    }
  }
}

/// Output pixels that are exactly one source pixel are copied bit for bit.
void copy_whole(std::span<const Pixel> source, const double* edges, const Weights& weights, std::span<Pixel> out) {
  for (size_t k = 0; k < out.size(); ++k) {
    const double first = weights.first[k];
    if (edges[k] == first && edges[k + 1] == first + 1) out[k] = source[static_cast<size_t>(weights.first[k])];
  }
}

/// @param edges  kBlock + 1 edges; the first out.size() + 1 count.
void resample_block(std::span<const Pixel> source, const double* edges, std::span<Pixel> out) {
  Weights weights;
  const Shape shape = weigh(edges, source.size(), weights);
  if (shape.all_whole) {
    std::memcpy(out.data()->val, source[static_cast<size_t>(weights.first[0])].val, out.size_bytes());
    return;
  }
  const bool safe = shape.lowest < 0 || shape.highest >= static_cast<ptrdiff_t>(source.size());
  if (shape.longest == 1) {
    (safe ? short_block<1, true> : short_block<1, false>)(source, weights, out);
  } else if (shape.longest == 2) {
    (safe ? short_block<2, true> : short_block<2, false>)(source, weights, out);
  } else {
    (safe ? mixed_block<true> : mixed_block<false>)(source, weights, out);
  }
  if (shape.any_whole) copy_whole(source, edges, weights, out);
}

void resample_interior(std::span<const Pixel> source, std::span<const double> edges, std::span<Pixel> out) {
  size_t k = 0;
  for (; k + kBlock <= out.size(); k += kBlock) resample_block(source, edges.data() + k, out.subspan(k, kBlock));
  if (k == out.size()) return;
  std::array<double, kBlock + 1> padded;
  const auto end = std::copy(edges.begin() + static_cast<ptrdiff_t>(k), edges.end(), padded.begin());
  std::fill(end, padded.end(), edges.back());
  resample_block(source, padded.data(), out.subspan(k));
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp {
namespace detail {
HWY_EXPORT(resample_interior);
}

void resample_line(std::span<const Pixel> source, const LineEdges& line, std::span<Pixel> out) noexcept {
  assert(!source.empty());
  assert(line.edges.size() == out.size() + 1);
  const auto [begin, end] = covered_pixels(line, out.size());
  std::fill(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(begin), Pixel::all(0));
  std::fill(out.begin() + static_cast<std::ptrdiff_t>(end), out.end(), Pixel::all(0));
  if (begin == end) return;
  const std::size_t count = end - begin;
  HWY_DYNAMIC_DISPATCH(detail::resample_interior)
  (source, line.edges.subspan(begin, count + 1), out.subspan(begin, count));
  for (const std::size_t k : {begin, end - 1}) {
    const double covered = coverage(line, k);
    if (covered < 1) out[k] *= static_cast<float>(covered);
    if (count == 1) break;
  }
}

}  // namespace morphkit::warp
#endif  // HWY_ONCE
