// Lines that are evaluated at every pixel of a tile. Included once per instruction set; the guard toggles accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_NEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_NEAR_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_NEAR_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_NEAR_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "hwy/highway.h"
#include "warp/field/line_field_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kTilePixels = size_t{kFieldTile} * kFieldTile;

/// Chunks per block: the sums of a block are added up first, then added to those of earlier blocks. The error of a sum
/// then grows with chunk + block + lines / (chunk block), see sum_units.
constexpr int kChunksPerBlock = 16;

inline double sum_units(const FieldTables& tables) {
  const int chunks = tables.padded() / kLineChunk;
  const int blocks = chunks / kChunksPerBlock;
  return kLineChunk + std::min(chunks, kChunksPerBlock) + blocks + 4;
}

/// Weights and weighted channels of a tile's pixels, row by row.
template <int kChannels>
struct Sums {
  alignas(64) float weight[kTilePixels];
  alignas(64) float channel[kChannels][kTilePixels];
  alignas(64) float error[kTilePixels], nearest[kTilePixels];  // of careful lines only

  void clear() {
    std::fill(std::begin(weight), std::end(weight), 0.0f);
    for (auto& sum : channel) std::fill(std::begin(sum), std::end(sum), 0.0f);
  }
  void add(const Sums& other) {
    for (size_t i = 0; i < kTilePixels; ++i) weight[i] += other.weight[i];
    for (size_t c = 0; c < kChannels; ++c) {
      for (size_t i = 0; i < kTilePixels; ++i) channel[c][i] += other.channel[c][i];
    }
  }
};

/// The part of a chunk of lines in the sums of one vector of pixels, held in registers.
template <int kChannels, class D>
struct Accumulator {
  hn::Vec<D> offset, weight;
  hn::Vec<D> channel[kChannels];

  HWY_INLINE void start(D d, size_t column) {
    offset = hn::Iota(d, static_cast<float>(column) - kHalf);
    weight = hn::Zero(d);
    for (size_t c = 0; c < kChannels; ++c) channel[c] = hn::Zero(d);
  }
  HWY_INLINE void stop(D d, size_t pixel, Sums<kChannels>& sums) const {
    const auto add = [d, pixel](hn::Vec<D> value, float* to) {
      hn::Store(hn::Add(value, hn::Load(d, to + pixel)), d, to + pixel);
    };
    add(weight, sums.weight);
    for (size_t c = 0; c < kChannels; ++c) add(channel[c], sums.channel[c]);
  }
  template <class Chunk>
  HWY_INLINE void add(D d, hn::Vec<D> line_weight, const Chunk& chunk, size_t i) {
    weight = hn::Add(weight, line_weight);
    for (size_t c = 0; c < kChannels; ++c) {
      const auto value = hn::MulAdd(offset, hn::Set(d, chunk.slope_x[c][i]), hn::Set(d, chunk.row_at[c][i]));
      channel[c] = hn::MulAdd(line_weight, value, channel[c]);
    }
  }
};

/// The channels of up to kLineChunk lines; in row ky they are at + ky slope_y.
template <int kChannels>
struct ChunkChannels {
  alignas(64) float at[kChannels][kLineChunk] = {}, slope_x[kChannels][kLineChunk] = {},
                    slope_y[kChannels][kLineChunk] = {};
  alignas(64) float row_at[kChannels][kLineChunk];

  void take(const View<kChannels>& view, size_t line, size_t i) {
    for (size_t c = 0; c < kChannels; ++c) {
      at[c][i] = view.at[c][line];
      slope_x[c][i] = view.slope_x[c][line];
      slope_y[c][i] = view.slope_y[c][line];
    }
  }
  void move_to_row(float offset) {
    for (size_t c = 0; c < kChannels; ++c) {
      for (size_t i = 0; i < kLineChunk; ++i) row_at[c][i] = at[c][i] + offset * slope_y[c][i];
    }
  }
};

// ---- Lines for which plain float distances are accurate enough.

template <int kChannels>
struct PlainChunk : ChunkChannels<kChannels> {
  // Halved, as plus_twice_root needs it, and divided by the root, which saves a multiplication.
  alignas(64) float across[kLineChunk] = {}, along[kLineChunk] = {},
                    reach[kLineChunk] = {};  // along: from the line's middle
  alignas(64) float along_x[kLineChunk] = {}, along_y[kLineChunk] = {};
  alignas(64) float row_across[kLineChunk], row_along[kLineChunk];
  alignas(64) float a[kLineChunk] = {};
  alignas(64) float power[kLineChunk] = {}, scale[kLineChunk] = {};  // kAny

  PlainChunk(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view, WeightKind kind,
             std::span<const int> lines) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const auto line = static_cast<size_t>(lines[i]);
      this->take(view, line, i);
      const float size = kind == WeightKind::kAny ? 1 : 1 / tables.root_single[line];
      across[i] = 0.5f * size * view.across[line];
      along[i] = 0.25f * size * (view.after[line] - view.before[line]);
      reach[i] = -0.25f * size * (view.after[line] + view.before[line]);
      along_x[i] = 0.5f * size * tables.along_x_single[line];
      along_y[i] = 0.5f * size * tables.along_y_single[line];
      a[i] = size * tables.a_single[line];
      power[i] = tables.power_single[line];
      scale[i] = tables.scale_single[line] + tile.scale;
    }
  }

  void move_to(float offset) {
    this->move_to_row(offset);
    for (size_t i = 0; i < kLineChunk; ++i) {
      row_across[i] = across[i] + offset * along_x[i];
      row_along[i] = along[i] + offset * along_y[i];
    }
  }
};

/// Added to squared distances so that no root is taken of 0; its root is far below kOnLinePx.
constexpr float kTinySquarePx = 0x1p-60f;

/// The weight of line i for pixels at `offset`.
template <WeightKind kKind, int kChannels, class D, class V = hn::Vec<D>>
HWY_INLINE V plain_weight(D d, V offset, const PlainChunk<kChannels>& chunk, size_t i) {
  const V across = hn::NegMulAdd(offset, hn::Set(d, chunk.along_y[i]), hn::Set(d, chunk.row_across[i]));
  const V along = hn::MulAdd(offset, hn::Set(d, chunk.along_x[i]), hn::Set(d, chunk.row_along[i]));
  const V beyond = hn::Max(hn::Sub(hn::Abs(along), hn::Set(d, chunk.reach[i])), hn::Zero(d));
  const V square = hn::MulAdd(across, across, hn::MulAdd(beyond, beyond, hn::Set(d, kTinySquarePx)));
  const V reach = plus_twice_root(d, square, hn::Set(d, chunk.a[i]));
  if constexpr (kKind == WeightKind::kAny) {
    return quick_power(d, reach, hn::Set(d, chunk.power[i]), hn::Set(d, chunk.scale[i]));
  } else if constexpr (kKind == WeightKind::kTwo) {
    return quick_inverse_square(d, reach);
  } else {
    return rooted_weight<kKind>(quick_reciprocal(d, reach));
  }
}

template <WeightKind kKind, int kChannels>
void add_plain(PlainChunk<kChannels>& chunk, size_t count, Sums<kChannels>& sums) {
  using D = hn::CappedTag<float, kFieldTile>;
  const D d;
  for (int y = 0; y < kFieldTile; ++y) {
    chunk.move_to(static_cast<float>(y - kHalf));
    for (size_t x = 0; x < kFieldTile; x += hn::Lanes(d)) {
      const size_t pixel = static_cast<size_t>(y) * kFieldTile + x;
      Accumulator<kChannels, D> lanes;
      lanes.start(d, x);
      for (size_t i = 0; i < count; ++i) lanes.add(d, plain_weight<kKind>(d, lanes.offset, chunk, i), chunk, i);
      lanes.stop(d, pixel, sums);
    }
  }
}

// ---- Lines so near, for their a, that a float is too coarse for the distance.

/// Numbers as sums of two floats.
struct SplitChunk {
  alignas(64) float hi[kLineChunk] = {}, lo[kLineChunk] = {};

  /// hi lies on a grid of 2^-17. hi and hi + k slope_hi are exact in float for every offset k while they stay below
  /// 2^7, so a value that passes through 0 within a tile keeps its relative precision. A value that starts above 2^6
  /// does not come near 0.
  void put(double value, size_t i) {
    const double on_grid = std::abs(value) < 0x1p6 ? std::nearbyint(value * 0x1p17) * 0x1p-17 : value;
    hi[i] = static_cast<float>(on_grid);
    lo[i] = static_cast<float>(value - static_cast<double>(hi[i]));
  }
  void put_exponent(double value, double grid, size_t i) {
    hi[i] = static_cast<float>(std::nearbyint(value * grid) / grid);
    lo[i] = static_cast<float>(value - static_cast<double>(hi[i]));
  }
  void move(const SplitChunk& at, const SplitChunk& slope, float offset) {
    for (size_t i = 0; i < kLineChunk; ++i) {
      hi[i] = at.hi[i] + offset * slope.hi[i];
      lo[i] = at.lo[i] + offset * slope.lo[i];
    }
  }
};

template <int kChannels>
struct CarefulChunk : ChunkChannels<kChannels> {
  SplitChunk across, before, after;
  SplitChunk along_x, along_y, minus_along_y;
  SplitChunk row_across, row_before, row_after;
  SplitChunk power, scale;  // kAny
  alignas(64) float a[kLineChunk] = {}, root[kLineChunk] = {};
  alignas(64) float error[kLineChunk] = {};  // px, bound on this line's part in the error of a mean

  CarefulChunk(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view,
               std::span<const int> lines) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const auto line = static_cast<size_t>(lines[i]);
      this->take(view, line, i);
      const double dx = tile.x - tables.origin_x[line];
      const double dy = tile.y - tables.origin_y[line];
      const double ux = tables.along_x[line];
      const double uy = tables.along_y[line];
      const double along = dx * ux + dy * uy;
      across.put(dy * ux - dx * uy, i);
      before.put(-along, i);
      after.put(along - tables.length[line], i);
      along_x.put(ux, i);
      along_y.put(uy, i);
      minus_along_y.put(-uy, i);
      // Products of power.hi with an integer exponent are exact.
      power.put_exponent(-tables.b[line], 256, i);
      scale.put_exponent(std::max(tables.log2_factor[line], kLeastLog2) + static_cast<double>(tile.scale), 1, i);
      a[i] = static_cast<float>(tables.a[line]);
      root[i] = static_cast<float>(tables.root[line]);
      // The error of a weight is at most (12 b + 8) units of roundoff: 8 from the distance and a, 4 from the
      // reciprocal, the rest from the power. It counts twice because it acts on differences from the mean, not from the
      // base. A channel adds 6 units.
      const double units = 2 * (12 * tables.b[line] + 8) + 2 * sum_units(tables) + 6;
      error[i] = static_cast<float>(kUnitRoundoff * units * static_cast<double>(view.spread[line]));
    }
  }

  void move_to(float offset) {
    this->move_to_row(offset);
    row_across.move(across, along_x, offset);
    row_before.move(before, minus_along_y, offset);
    row_after.move(after, along_y, offset);
  }
};

/// a + distance.
template <int kChannels, class D, class V = hn::Vec<D>>
HWY_INLINE V careful_reach(D d, V offset, const CarefulChunk<kChannels>& chunk, size_t i) {
  const auto set = [d](float value) { return hn::Set(d, value); };
  const V x_hi = set(chunk.along_x.hi[i]);
  const V x_lo = set(chunk.along_x.lo[i]);
  const V across = hn::Add(hn::NegMulAdd(offset, set(chunk.along_y.hi[i]), set(chunk.row_across.hi[i])),
                           hn::NegMulAdd(offset, set(chunk.along_y.lo[i]), set(chunk.row_across.lo[i])));
  const V before = hn::Add(hn::NegMulAdd(offset, x_hi, set(chunk.row_before.hi[i])),
                           hn::NegMulAdd(offset, x_lo, set(chunk.row_before.lo[i])));
  const V after = hn::Add(hn::MulAdd(offset, x_hi, set(chunk.row_after.hi[i])),
                          hn::MulAdd(offset, x_lo, set(chunk.row_after.lo[i])));
  const V beyond = hn::Max(hn::Max(before, after), hn::Zero(d));
  const V square = hn::MulAdd(across, across, hn::MulAdd(beyond, beyond, set(kTinySquarePx)));
  return plus_twice_root(d, hn::Mul(square, set(0.25f)), set(chunk.a[i]));
}

template <WeightKind kKind, int kChannels, class D, class V = hn::Vec<D>>
HWY_INLINE V careful_weight(D d, V reach, const CarefulChunk<kChannels>& chunk, size_t i) {
  if constexpr (kKind == WeightKind::kAny) {
    const SplitVector<V> power{hn::Set(d, chunk.power.hi[i]), hn::Set(d, chunk.power.lo[i])};
    const SplitVector<V> scale{hn::Set(d, chunk.scale.hi[i]), hn::Set(d, chunk.scale.lo[i])};
    return scaled_power(d, reach, power, scale);
  } else {
    return rooted_weight<kKind>(hn::Mul(hn::Set(d, chunk.root[i]), quick_reciprocal(d, reach)));
  }
}

template <WeightKind kKind, int kChannels>
void add_careful(CarefulChunk<kChannels>& chunk, size_t count, Sums<kChannels>& sums) {
  using D = hn::CappedTag<float, kFieldTile>;
  const D d;
  const auto on_line = hn::Set(d, static_cast<float>(kOnLinePx));
  for (int y = 0; y < kFieldTile; ++y) {
    chunk.move_to(static_cast<float>(y - kHalf));
    for (size_t x = 0; x < kFieldTile; x += hn::Lanes(d)) {
      const size_t pixel = static_cast<size_t>(y) * kFieldTile + x;
      Accumulator<kChannels, D> lanes;
      lanes.start(d, x);
      auto error = hn::Load(d, sums.error + pixel);
      auto nearest = hn::Load(d, sums.nearest + pixel);
      for (size_t i = 0; i < count; ++i) {
        const auto reach = careful_reach(d, lanes.offset, chunk, i);
        nearest = hn::Min(nearest, reach);
        // Pixels on a line are computed again later; here they only must stay finite.
        const auto weight = careful_weight<kKind>(d, hn::Max(reach, on_line), chunk, i);
        error = hn::MulAdd(weight, hn::Set(d, chunk.error[i]), error);
        lanes.add(d, weight, chunk, i);
      }
      lanes.stop(d, pixel, sums);
      hn::Store(error, d, sums.error + pixel);
      hn::Store(nearest, d, sums.nearest + pixel);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
