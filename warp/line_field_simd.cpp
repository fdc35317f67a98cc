// The kernel behind LineField::row: blocks of kFieldBlock pixels, float lanes over pixels, lines in chunks.
//
// What keeps float arithmetic close to the double reference:
//  - Everything affine along the row is evaluated in double once per block and line, at the block's middle pixel.
//  - Distances are carried as two floats (see split), so that a distance near 0 has a small *relative* error.
//  - Displacements are taken relative to a base, an affine guess at the block's mean, so that only their differences
//  are
//    rounded; a single pair or equal pairs come out as good as in double.
//  - Weights are summed a chunk at a time: the error of a sum grows with chunk + lines / chunk, not with lines.
//  - A bound on the error is accumulated beside the sums with the weights themselves. A pixel that cannot be shown to
//    be within kFieldTolerancePx, or that lies on a line, is taken from the reference.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "warp/line_field_tables.h"

// Vectors are kept in arrays here, which targets without a fixed vector size do not allow; such machines have NEON too.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/line_field_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"
#include "warp/line_field_power-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Offsets of a block's pixels from its middle pixel: [-kHalf, kHalf).
constexpr int kHalf = kFieldBlock / 2;
/// log2 of about the largest weight of a block, if weights are scaled: the nearest line of any pixel then stays 40 bits
/// above what a float drops, and sums of many displacements far from overflow.
constexpr double kScaledPeak = 80;
constexpr double kUnitRoundoff = 0x1p-24;
/// For each of the two coordinates, so that their distance keeps to kFieldTolerancePx.
constexpr double kCoordinateTolerancePx = 0.7 * kFieldTolerancePx;

/// The lines of one chunk as seen from the block's middle pixel. An affine quantity at offset k is
/// (hi + k slope_hi) + (lo + k slope_lo).
template <int kChannels>
struct Chunk {
  struct Split {
    alignas(64) float hi[kLineChunk], lo[kLineChunk];
  };
  Split across, across_slope;  // v
  Split before, after;         // -u |Q - P|; (u - 1) |Q - P|
  Split along_slope;           // of `after`; that of `before` is its opposite
  alignas(64) float a[kLineChunk];
  alignas(64) float root[kLineChunk];   // kinds other than kAny
  Split power;                          // kAny: -b
  Split scale;                          // kAny: log2 of the factor of the weight
  alignas(64) float error[kLineChunk];  // px, what this line alone could contribute to a mean's error
  alignas(64) float at[kChannels][kLineChunk], slope[kChannels][kLineChunk];
};

template <int kChannels>
struct Sums {
  alignas(64) float weight[kFieldBlock], error[kFieldBlock], nearest[kFieldBlock];
  alignas(64) float channel[kChannels][kFieldBlock];
};

/// Where a block is and what its channels are measured from.
template <int kChannels>
struct Block {
  double x, y;  // centre of the middle pixel
  std::array<int, kChannels> channels;
  std::array<double, kChannels> base, base_slope;
  double scale;  // log2 of the common factor of all weights; kAny only
};

// ---- Once per block, over lines, in double.

/// Sets the base: the mean of the lines' channels at the middle pixel under weights of about the right shape. Any base
/// is correct; a good one keeps the differences small.
template <int kChannels>
void set_base(const FieldTables& tables, Block<kChannels>& block) {
  const hn::CappedTag<double, kLineChunk> d;
  using V = hn::Vec<decltype(d)>;
  const auto load = [d](const double* array, int i) { return hn::LoadU(d, array + i); };
  V total = hn::Zero(d);
  V at[kChannels];
  V slope[kChannels];
  for (int c = 0; c < kChannels; ++c) at[c] = slope[c] = hn::Zero(d);
  for (int i = 0; i < tables.padded(); i += static_cast<int>(hn::Lanes(d))) {
    const V dx = hn::Sub(hn::Set(d, block.x), load(tables.origin_x.data(), i));
    const V dy = hn::Sub(hn::Set(d, block.y), load(tables.origin_y.data(), i));
    const V ux = load(tables.along_x.data(), i);
    const V uy = load(tables.along_y.data(), i);
    const V along = hn::MulAdd(dx, ux, hn::Mul(dy, uy));
    const V across = hn::Sub(hn::Mul(dy, ux), hn::Mul(dx, uy));
    const V beyond = hn::Max(hn::Max(hn::Neg(along), hn::Sub(along, load(tables.length.data(), i))), hn::Zero(d));
    const V distance = hn::Sqrt(hn::MulAdd(across, across, hn::Mul(beyond, beyond)));
    const V soft = hn::Add(hn::Add(distance, load(tables.a.data(), i)), hn::Set(d, kHalf / 2));
    const V weight = hn::Div(load(tables.factor.data(), i), hn::Mul(soft, soft));
    total = hn::Add(total, weight);
    for (int c = 0; c < kChannels; ++c) {
      const int channel = block.channels[static_cast<size_t>(c)];
      const V slope_x = load(tables.slope_x(channel), i);
      const V value =
          hn::MulAdd(load(tables.slope_y(channel), i), dy, hn::MulAdd(slope_x, dx, load(tables.at(channel), i)));
      at[c] = hn::MulAdd(weight, value, at[c]);
      slope[c] = hn::MulAdd(weight, slope_x, slope[c]);
    }
  }
  const double sum = hn::GetLane(hn::SumOfLanes(d, total));
  for (size_t c = 0; c < kChannels; ++c) {
    block.base[c] = hn::GetLane(hn::SumOfLanes(d, at[c])) / sum;
    block.base_slope[c] = hn::GetLane(hn::SumOfLanes(d, slope[c])) / sum;
  }
}

/// The scale that takes the largest weight that can occur in the block to 2^kScaledPeak. Within a block, the distance
/// to the nearest line changes from kOnLinePx to kFieldBlock at most: by 2^20, to the power of 8.
double block_scale(const FieldTables& tables, double x, double y) {
  double peak = -HUGE_VAL;
  for (size_t i = 0; i < static_cast<size_t>(tables.padded()); ++i) {
    const double dx = x - tables.origin_x[i];
    const double dy = y - tables.origin_y[i];
    const double along = dx * tables.along_x[i] + dy * tables.along_y[i];
    const double across = dy * tables.along_x[i] - dx * tables.along_y[i];
    const double beyond = std::max(std::max(-along, along - tables.length[i]), 0.0);
    const double distance = std::sqrt(across * across + beyond * beyond);
    const double reach = std::max(tables.a[i] + std::max(distance - kHalf, 0.0), kOnLinePx);
    peak = std::max(peak, tables.log2_factor[i] - tables.b[i] * std::log2(reach));
  }
  return kScaledPeak - peak;
}

/// Writes value as hi + lo. On the grid of 2^-17, hi + k slope_hi is exact in float for every offset k as long as it is
/// below 2^7, so a value that passes through 0 within a block keeps its relative precision; one that starts above 2^6
/// cannot come near 0.
template <class D, class V, class Split>
HWY_INLINE void split(D d, V value, Split& to, size_t i) {
  const hn::Rebind<float, D> df;
  const V to_grid = hn::Set(d, 0x1.8p35);  // adding it leaves 17 fraction bits in a double
  const V on_grid = hn::Sub(hn::Add(value, to_grid), to_grid);
  const V chosen = hn::IfThenElse(hn::Lt(hn::Abs(value), hn::Set(d, 2.0 * kHalf)), on_grid, value);
  const auto hi = hn::DemoteTo(df, chosen);
  hn::Store(hi, df, to.hi + i);
  hn::Store(hn::DemoteTo(df, hn::Sub(value, hn::PromoteTo(d, hi))), df, to.lo + i);
}

template <int kChannels>
void fill_geometry(const FieldTables& tables, int begin, const Block<kChannels>& block, Chunk<kChannels>& chunk) {
  const hn::CappedTag<double, kLineChunk> d;
  const hn::Rebind<float, decltype(d)> df;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = 0; i < kLineChunk; i += hn::Lanes(d)) {
    const auto load = [d, line = static_cast<size_t>(begin) + i](const std::vector<double>& array) {
      return hn::LoadU(d, array.data() + line);
    };
    const V dx = hn::Sub(hn::Set(d, block.x), load(tables.origin_x));
    const V dy = hn::Sub(hn::Set(d, block.y), load(tables.origin_y));
    const V ux = load(tables.along_x);
    const V uy = load(tables.along_y);
    const V along = hn::Add(hn::Mul(dx, ux), hn::Mul(dy, uy));
    split(d, hn::Sub(hn::Mul(dy, ux), hn::Mul(dx, uy)), chunk.across, i);
    split(d, hn::Neg(uy), chunk.across_slope, i);
    split(d, hn::Neg(along), chunk.before, i);
    split(d, hn::Sub(along, load(tables.length)), chunk.after, i);
    split(d, ux, chunk.along_slope, i);
    hn::Store(hn::DemoteTo(df, load(tables.a)), df, chunk.a + i);
    hn::Store(hn::DemoteTo(df, load(tables.root)), df, chunk.root + i);
  }
}

template <int kChannels>
void fill_power(const FieldTables& tables, int begin, const Block<kChannels>& block, Chunk<kChannels>& chunk) {
  for (size_t i = 0; i < kLineChunk; ++i) {
    const size_t line = static_cast<size_t>(begin) + i;
    // Products of power.hi with an integer exponent are exact.
    const double power = -tables.b[line];
    const double power_hi = std::nearbyint(power * 256) / 256;
    chunk.power.hi[i] = static_cast<float>(power_hi);
    chunk.power.lo[i] = static_cast<float>(power - power_hi);
    const double scale = std::max(tables.log2_factor[line] + block.scale, -1e4);
    const double scale_hi = std::nearbyint(scale);
    chunk.scale.hi[i] = static_cast<float>(scale_hi);
    chunk.scale.lo[i] = static_cast<float>(scale - scale_hi);
  }
}

/// Channels relative to the base, and what their rounding can do to a mean: a weight is off by at most (10 b + 8) units
/// of roundoff (7 from the distance and a, the rest from the power), a sum by one unit for each term it passes, and a
/// channel by 6 of its own; weights count twice because they act on differences from the mean rather than the base.
template <int kChannels>
void fill_channels(const FieldTables& tables, int begin, const Block<kChannels>& block, Chunk<kChannels>& chunk) {
  alignas(64) double spread[kLineChunk] = {};
  for (size_t c = 0; c < kChannels; ++c) {
    const int channel = block.channels[c];
    const double* at = tables.at(channel) + begin;
    const double* slope_x = tables.slope_x(channel) + begin;
    const double* slope_y = tables.slope_y(channel) + begin;
    const bool in_pixels = channel != tables.value_channel();
    for (size_t i = 0; i < kLineChunk; ++i) {
      const double dx = block.x - tables.origin_x[static_cast<size_t>(begin) + i];
      const double dy = block.y - tables.origin_y[static_cast<size_t>(begin) + i];
      const double middle = (at[i] + slope_x[i] * dx + slope_y[i] * dy) - block.base[c];
      const double slope = slope_x[i] - block.base_slope[c];
      chunk.at[c][i] = static_cast<float>(middle);
      chunk.slope[c][i] = static_cast<float>(slope);
      const double largest = std::abs(middle) + kHalf * std::abs(slope);
      spread[i] = in_pixels && largest > spread[i] ? largest : spread[i];
    }
  }
  const auto chunks = tables.padded() / kLineChunk;
  const auto sums = static_cast<double>(kLineChunk + chunks + 3);
  for (size_t i = 0; i < kLineChunk; ++i) {
    const double units = 2 * (10 * tables.b[static_cast<size_t>(begin) + i] + 8) + 2 * sums + 6;
    chunk.error[i] = static_cast<float>(kUnitRoundoff * units * spread[i]);
  }
}

// ---- Per pixel, in float lanes.

template <WeightKind kKind, int kChannels, class D, class V = hn::Vec<D>>
HWY_INLINE V weight_of(D d, V reach, const Chunk<kChannels>& chunk, size_t i) {
  if constexpr (kKind == WeightKind::kAny) {
    const SplitVector<V> power{hn::Set(d, chunk.power.hi[i]), hn::Set(d, chunk.power.lo[i])};
    const SplitVector<V> scale{hn::Set(d, chunk.scale.hi[i]), hn::Set(d, chunk.scale.lo[i])};
    return scaled_power(d, reach, power, scale);
  } else {
    const V ratio = hn::Div(hn::Set(d, chunk.root[i]), reach);
    if constexpr (kKind == WeightKind::kOne) return ratio;
    if constexpr (kKind == WeightKind::kOneAndHalf) return hn::Mul(ratio, hn::Sqrt(ratio));
    return hn::Mul(ratio, ratio);
  }
}

/// a + distance from line i for the pixels at `offset`.
template <int kChannels, class D, class V = hn::Vec<D>>
HWY_INLINE V reach_of(D d, V offset, const Chunk<kChannels>& chunk, size_t i) {
  const auto set = [d](float value) { return hn::Set(d, value); };
  const V slope_hi = set(chunk.along_slope.hi[i]);
  const V slope_lo = set(chunk.along_slope.lo[i]);
  const V across = hn::Add(hn::MulAdd(offset, set(chunk.across_slope.hi[i]), set(chunk.across.hi[i])),
                           hn::MulAdd(offset, set(chunk.across_slope.lo[i]), set(chunk.across.lo[i])));
  const V before = hn::Add(hn::NegMulAdd(offset, slope_hi, set(chunk.before.hi[i])),
                           hn::NegMulAdd(offset, slope_lo, set(chunk.before.lo[i])));
  const V after = hn::Add(hn::MulAdd(offset, slope_hi, set(chunk.after.hi[i])),
                          hn::MulAdd(offset, slope_lo, set(chunk.after.lo[i])));
  const V beyond = hn::Max(hn::Max(before, after), hn::Zero(d));
  return hn::Add(set(chunk.a[i]), hn::Sqrt(hn::MulAdd(across, across, hn::Mul(beyond, beyond))));
}

/// One vector of pixels' sums while they are in registers.
template <int kChannels, class D>
struct Lanes {
  using V = hn::Vec<D>;
  V offset, total, error, nearest;
  V channel[kChannels];

  HWY_INLINE void start(D d, size_t k, const Sums<kChannels>& sums) {
    offset = hn::Iota(d, static_cast<float>(k) - kHalf);
    total = error = hn::Zero(d);
    nearest = hn::Load(d, sums.nearest + k);
    for (V& sum : channel) sum = hn::Zero(d);
  }

  template <WeightKind kKind>
  HWY_INLINE void add_line(D d, const Chunk<kChannels>& chunk, size_t i) {
    const V reach = reach_of(d, offset, chunk, i);
    nearest = hn::Min(nearest, reach);
    // Pixels on a line are redone; here they only must not become infinite.
    const V weight = weight_of<kKind>(d, hn::Max(reach, hn::Set(d, static_cast<float>(kOnLinePx))), chunk, i);
    total = hn::Add(total, weight);
    error = hn::MulAdd(weight, hn::Set(d, chunk.error[i]), error);
    for (size_t c = 0; c < kChannels; ++c) {
      const V value = hn::MulAdd(offset, hn::Set(d, chunk.slope[c][i]), hn::Set(d, chunk.at[c][i]));
      channel[c] = hn::MulAdd(weight, value, channel[c]);
    }
  }

  HWY_INLINE void stop(D d, size_t k, Sums<kChannels>& sums) const {
    hn::Store(nearest, d, sums.nearest + k);
    hn::Store(hn::Add(total, hn::Load(d, sums.weight + k)), d, sums.weight + k);
    hn::Store(hn::Add(error, hn::Load(d, sums.error + k)), d, sums.error + k);
    for (size_t c = 0; c < kChannels; ++c) {
      hn::Store(hn::Add(channel[c], hn::Load(d, sums.channel[c] + k)), d, sums.channel[c] + k);
    }
  }
};

/// Adds a chunk's weights and weighted channels to the sums of a block.
template <WeightKind kKind, int kChannels>
void accumulate(const Chunk<kChannels>& chunk, size_t count, Sums<kChannels>& sums) {
  const hn::CappedTag<float, kFieldBlock> d;
  Lanes<kChannels, hn::CappedTag<float, kFieldBlock>> lanes;
  for (size_t k = 0; k < kFieldBlock; k += hn::Lanes(d)) {
    lanes.start(d, k, sums);
    for (size_t i = 0; i < count; ++i) lanes.template add_line<kKind>(d, chunk, i);
    lanes.stop(d, k, sums);
  }
}

template <int kChannels>
void accumulate_as(WeightKind kind, const Chunk<kChannels>& chunk, size_t count, Sums<kChannels>& sums) {
  switch (kind) {
    case WeightKind::kOne:
      return accumulate<WeightKind::kOne>(chunk, count, sums);
    case WeightKind::kOneAndHalf:
      return accumulate<WeightKind::kOneAndHalf>(chunk, count, sums);
    case WeightKind::kTwo:
      return accumulate<WeightKind::kTwo>(chunk, count, sums);
    case WeightKind::kAny:
      return accumulate<WeightKind::kAny>(chunk, count, sums);
  }
}

template <int kChannels>
void sum_lines(const FieldTables& tables, const Block<kChannels>& block, Sums<kChannels>& sums) {
  sums = {};
  std::fill(std::begin(sums.nearest), std::end(sums.nearest), HUGE_VALF);
  Chunk<kChannels> chunk;
  for (const LineGroup& group : tables.groups()) {
    for (int done = 0; done < group.count; done += kLineChunk) {
      fill_geometry(tables, group.begin + done, block, chunk);
      fill_channels(tables, group.begin + done, block, chunk);
      if (group.kind == WeightKind::kAny) fill_power(tables, group.begin + done, block, chunk);
      accumulate_as(group.kind, chunk, static_cast<size_t>(std::min(group.count - done, kLineChunk)), sums);
    }
  }
}

// ---- From sums to the caller's spans.

/// A row's part that a block covers: pixels [from, to) of the block are elements [first, ...) of the spans.
struct Part {
  int from, to, first;
};

/// Means in channel units; unsafe[k] is set where the reference must be asked.
template <int kChannels>
struct Means {
  double channel[kChannels][kFieldBlock];
  int unsafe[kFieldBlock];
};

template <int kChannels>
void finish(const FieldTables& tables, const Block<kChannels>& block, const Sums<kChannels>& sums,
            Means<kChannels>& means) {
  // The lines' distances are known to 2^-22 of themselves: this margin leaves the decision to the reference.
  constexpr auto kNear = static_cast<float>(kOnLinePx * (1 + 0x1p-8));
  for (size_t k = 0; k < kFieldBlock; ++k) means.unsafe[k] = sums.nearest[k] < kNear ? 1 : 0;
  for (size_t c = 0; c < kChannels; ++c) {
    const bool in_pixels = block.channels[c] != tables.value_channel();
    const double origin = !in_pixels ? 0 : block.channels[c] % 2 == 0 ? block.x : block.y;
    const double origin_slope = in_pixels && block.channels[c] % 2 == 0 ? 1 : 0;
    for (size_t k = 0; k < kFieldBlock; ++k) {
      const double offset = static_cast<double>(static_cast<int>(k) - kHalf);
      const double mean = static_cast<double>(sums.channel[c][k] / sums.weight[k]);
      const double result = (origin + offset * origin_slope) + ((block.base[c] + offset * block.base_slope[c]) + mean);
      means.channel[c][k] = result;
      // Both results are rounded to float at the end: 2^-23 of the position between them. NaN must count as unsafe.
      const double bound = static_cast<double>(sums.error[k] / sums.weight[k]) + std::abs(result) * 0x1p-23;
      means.unsafe[k] |= !in_pixels || bound <= kCoordinateTolerancePx ? 0 : 1;
    }
  }
}

template <int kChannels>
int ask_reference(const FieldTables& tables, const Block<kChannels>& block, const Part& part, Means<kChannels>& means) {
  int asked = 0;
  for (int pixel = part.from; pixel < part.to; ++pixel) {
    const auto k = static_cast<size_t>(pixel);
    if (means.unsafe[k] == 0) continue;
    ++asked;
    const double x = block.x + (pixel - kHalf);
    std::array<double, kChannels> exact;
    reference_point(tables, x, block.y, block.channels, exact);
    for (size_t c = 0; c < kChannels; ++c) {
      const bool in_pixels = block.channels[c] != tables.value_channel();
      const double origin = !in_pixels ? 0 : block.channels[c] % 2 == 0 ? x : block.y;
      means.channel[c][k] = origin + exact[c];
    }
  }
  return asked;
}

template <int kChannels>
void emit(const FieldTables& tables, const Block<kChannels>& block, const Part& part, const Means<kChannels>& means,
          std::span<const std::span<MapPoint>> positions, std::span<float> values) {
  const auto from = static_cast<size_t>(part.from);
  const auto count = static_cast<size_t>(part.to - part.from);
  const auto first = static_cast<size_t>(part.first);
  for (size_t c = 0; c + 1 < kChannels; c += 2) {
    MapPoint* out = positions[static_cast<size_t>(block.channels[c]) / 2].data() + first;
    for (size_t i = 0; i < count; ++i) {
      out[i] = {static_cast<float>(means.channel[c][from + i]), static_cast<float>(means.channel[c + 1][from + i])};
    }
  }
  if constexpr (kChannels % 2 == 1) {
    for (size_t i = 0; i < count; ++i) {
      values[first + i] = static_cast<float>(tables.value_from_channel(means.channel[kChannels - 1][from + i]));
    }
  }
}

/// One pass over a row for one or two targets from `target` on, with the values if kChannels is odd. Blocks lie at
/// multiples of kFieldBlock whatever x_begin is.
template <int kChannels>
int run_pass(const FieldTables& tables, int y, int x_begin, int target, std::span<const std::span<MapPoint>> positions,
             std::span<float> values) {
  Block<kChannels> block{};
  for (int c = 0; c < kChannels; ++c) block.channels[static_cast<size_t>(c)] = 2 * target + c;
  if constexpr (kChannels % 2 == 1) block.channels.back() = tables.value_channel();
  Sums<kChannels> sums;
  Means<kChannels> means;
  const int n = static_cast<int>(positions.front().size());
  int asked = 0;
  const int lead = (x_begin % kFieldBlock + kFieldBlock) % kFieldBlock;
  for (int start = -lead; start < n; start += kFieldBlock) {
    block.x = static_cast<double>(x_begin) + (start + kHalf) + 0.5;
    block.y = y + 0.5;
    set_base(tables, block);
    if (tables.wide_range()) block.scale = block_scale(tables, block.x, block.y);
    sum_lines(tables, block, sums);
    finish(tables, block, sums, means);
    const Part part{std::max(-start, 0), std::min(n - start, kFieldBlock), std::max(start, 0)};
    asked += ask_reference(tables, block, part, means);
    emit(tables, block, part, means, positions, values);
  }
  return asked;
}

int run_row(const FieldTables& tables, int y, int x_begin, std::span<const std::span<MapPoint>> positions,
            std::span<float> values) {
  int asked = 0;
  for (int target = 0; target < tables.targets(); target += 2) {
    const bool pair = target + 1 < tables.targets();
    const bool with_values = target == 0 && !values.empty();
    const auto pass = pair ? (with_values ? run_pass<5> : run_pass<4>) : (with_values ? run_pass<3> : run_pass<2>);
    asked += pass(tables, y, x_begin, target, positions, values);
  }
  return asked;
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {

HWY_EXPORT(run_row);

int simd_row(const FieldTables& tables, int y, int x_begin, std::span<const std::span<MapPoint>> positions,
             std::span<float> values) noexcept {
  if (tables.lines() == 0) {
    for (const auto& row : positions) {
      for (size_t i = 0; i < row.size(); ++i) {
        row[i] = {static_cast<float>(x_begin + static_cast<double>(i) + 0.5), static_cast<float>(y + 0.5)};
      }
    }
    std::fill(values.begin(), values.end(), 0.0f);
    return 0;
  }
  return HWY_DYNAMIC_DISPATCH(run_row)(tables, y, x_begin, positions, values);
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
