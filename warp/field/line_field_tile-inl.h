// The lines of a field relative to one tile of the output. Included once per instruction set; the guard toggles
// accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_TILE_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_TILE_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_TILE_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hwy/highway.h"
#include "warp/field/line_field_power-inl.h"
#include "warp/field/line_field_tables.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Offsets of a tile's pixels from its middle pixel: [-kHalf, kHalf) both ways.
constexpr int kHalf = kFieldTile / 2;
/// The largest distance of a tile's pixel centres from the centre of its middle pixel.
constexpr double kRadiusPx = 1.4142135623730951 * kHalf;
/// log2 of about the largest weight of a tile, if weights are scaled. The weight of the line nearest to any pixel then
/// stays 40 bits above the smallest float, and sums of many displacements stay far from overflow.
constexpr double kScaledPeak = 80;
constexpr double kUnitRoundoff = 0x1p-24;

/// The place of a tile and the base of its channels: channel c of every line is taken relative to
/// base[c] + base_x[c] kx + base_y[c] ky at offset (kx, ky).
template <int kChannels>
struct Tile {
  double x, y;  // centre of the middle pixel
  std::array<int, kChannels> channels;
  std::array<double, kChannels> base, base_x, base_y;
  float scale;  // log2 of the common factor of all weights, a whole number; kAny only
};

/// One float for each line, in the order of the tables.
using PerLine = std::vector<float>;

/// Every line relative to a tile. An affine quantity is given by its value at the middle pixel and its slopes; the
/// slopes of the geometry are in the tables. Reused from tile to tile: only its sizes persist.
template <int kChannels>
struct View {
  PerLine distance;                                      // px, from the middle pixel
  PerLine across, before, after;                         // v; -u |Q - P|; (u - 1) |Q - P|
  std::array<PerLine, kChannels> at, slope_x, slope_y;   // relative to the base
  PerLine spread;                                        // px, the largest of any channel over the tile
  PerLine turn;                                          // px, the part of it that comes from slopes
  PerLine weight_most;                                   // over the tile
  double total_least = 0;                                // of all lines, over the tile
  std::array<std::vector<double>, kChannels> at_double;  // before the base is known

  void resize(size_t lines) {
    for (PerLine* array : {&distance, &across, &before, &after, &spread, &turn, &weight_most}) array->resize(lines);
    for (auto* arrays : {&at, &slope_x, &slope_y}) {
      for (PerLine& array : *arrays) array.resize(lines);
    }
    for (auto& array : at_double) array.resize(lines);
  }
};

/// Calls fn<kind>(arguments...).
template <class Fn, class... Arguments>
HWY_INLINE void with_kind(WeightKind kind, const Fn& fn, Arguments&&... arguments) {
  switch (kind) {
    case WeightKind::kOne:
      return fn.template operator()<WeightKind::kOne>(arguments...);
    case WeightKind::kOneAndHalf:
      return fn.template operator()<WeightKind::kOneAndHalf>(arguments...);
    case WeightKind::kTwo:
      return fn.template operator()<WeightKind::kTwo>(arguments...);
    case WeightKind::kAny:
      return fn.template operator()<WeightKind::kAny>(arguments...);
  }
}

/// The weight of kinds other than kAny: ratio^b.
template <WeightKind kKind, class V>
HWY_INLINE V rooted_weight(V ratio) {
  static_assert(kKind != WeightKind::kAny);
  if constexpr (kKind == WeightKind::kOne) return ratio;
  if constexpr (kKind == WeightKind::kOneAndHalf) return hn::Mul(ratio, hn::Sqrt(ratio));
  return hn::Mul(ratio, ratio);
}

/// The weights of one vector of lines, beginning with `line`, at a + distance = reach.
template <WeightKind kKind, class D, class V = hn::Vec<D>>
HWY_INLINE V lane_weight(D d, V reach, const FieldTables& tables, float scale, size_t line) {
  if constexpr (kKind == WeightKind::kAny) {
    return quick_power(d, reach, hn::LoadU(d, &tables.power_single[line]),
                       hn::Add(hn::LoadU(d, &tables.scale_single[line]), hn::Set(d, scale)));
  } else {
    return rooted_weight<kKind>(hn::Mul(hn::LoadU(d, &tables.root_single[line]), quick_reciprocal(d, reach)));
  }
}

/// Computes geometry, channels and a base: the mean of the lines' channels at the middle pixel, with weights of roughly
/// the right shape. Any base is correct; with a good one the differences are small, and only they are rounded.
template <int kChannels>
void look_at_lines(const FieldTables& tables, Tile<kChannels>& tile, View<kChannels>& view) {
  const hn::CappedTag<double, kLineChunk> d;
  const hn::Rebind<float, decltype(d)> df;
  using V = hn::Vec<decltype(d)>;
  V total = hn::Zero(d);
  V at[kChannels], slope_x[kChannels], slope_y[kChannels];
  for (int c = 0; c < kChannels; ++c) at[c] = slope_x[c] = slope_y[c] = hn::Zero(d);
  for (size_t i = 0; i < static_cast<size_t>(tables.padded()); i += hn::Lanes(d)) {
    const auto load = [d, i](const auto& array) { return hn::LoadU(d, &array[i]); };
    const auto store = [df, i](V value, PerLine& to) { hn::StoreU(hn::DemoteTo(df, value), df, &to[i]); };
    const V dx = hn::Sub(hn::Set(d, tile.x), load(tables.origin_x));
    const V dy = hn::Sub(hn::Set(d, tile.y), load(tables.origin_y));
    const V ux = load(tables.along_x);
    const V uy = load(tables.along_y);
    const V along = hn::MulAdd(dx, ux, hn::Mul(dy, uy));
    const V across = hn::Sub(hn::Mul(dy, ux), hn::Mul(dx, uy));
    const V after = hn::Sub(along, load(tables.length));
    const V beyond = hn::Max(hn::Max(hn::Neg(along), after), hn::Zero(d));
    const V distance = hn::Sqrt(hn::MulAdd(across, across, hn::Mul(beyond, beyond)));
    store(across, view.across);
    store(hn::Neg(along), view.before);
    store(after, view.after);
    store(distance, view.distance);
    const V soft = hn::Add(hn::Add(distance, load(tables.a)), hn::Set(d, kHalf / 2));
    const V weight = hn::Div(load(tables.factor), hn::Mul(soft, soft));
    total = hn::Add(total, weight);
    for (size_t c = 0; c < kChannels; ++c) {
      const int channel = tile.channels[c];
      const V x = load(tables.slope_x(channel));
      const V y = load(tables.slope_y(channel));
      const V value = hn::MulAdd(y, dy, hn::MulAdd(x, dx, load(tables.at(channel))));
      hn::StoreU(value, d, &view.at_double[c][i]);
      at[c] = hn::MulAdd(weight, value, at[c]);
      slope_x[c] = hn::MulAdd(weight, x, slope_x[c]);
      slope_y[c] = hn::MulAdd(weight, y, slope_y[c]);
    }
  }
  const double sum = hn::GetLane(hn::SumOfLanes(d, total));
  for (size_t c = 0; c < kChannels; ++c) {
    tile.base[c] = hn::GetLane(hn::SumOfLanes(d, at[c])) / sum;
    tile.base_x[c] = hn::GetLane(hn::SumOfLanes(d, slope_x[c])) / sum;
    tile.base_y[c] = hn::GetLane(hn::SumOfLanes(d, slope_y[c])) / sum;
  }
}

/// Makes the channels relative to the base.
template <int kChannels>
void measure_from_base(const FieldTables& tables, const Tile<kChannels>& tile, View<kChannels>& view) {
  const hn::CappedTag<double, kLineChunk> d;
  const hn::Rebind<float, decltype(d)> df;
  const auto half = hn::Set(df, static_cast<float>(kHalf));
  for (size_t i = 0; i < static_cast<size_t>(tables.padded()); i += hn::Lanes(d)) {
    auto spread = hn::Zero(df), turn = hn::Zero(df);
    for (size_t c = 0; c < kChannels; ++c) {
      const int channel = tile.channels[c];
      const auto relative = [&](const double* array, double base) {
        return hn::DemoteTo(df, hn::Sub(hn::LoadU(d, array), hn::Set(d, base)));
      };
      const auto at = relative(&view.at_double[c][i], tile.base[c]);
      const auto slope_x = relative(tables.slope_x(channel) + i, tile.base_x[c]);
      const auto slope_y = relative(tables.slope_y(channel) + i, tile.base_y[c]);
      hn::StoreU(at, df, &view.at[c][i]);
      hn::StoreU(slope_x, df, &view.slope_x[c][i]);
      hn::StoreU(slope_y, df, &view.slope_y[c][i]);
      const auto slopes = hn::Mul(half, hn::Add(hn::Abs(slope_x), hn::Abs(slope_y)));
      spread = hn::Max(spread, hn::Add(slopes, hn::Abs(at)));
      turn = hn::Max(turn, slopes);
    }
    hn::StoreU(turn, df, &view.turn[i]);
    hn::StoreU(spread, df, &view.spread[i]);
  }
}

/// The scale that brings the largest possible weight of the tile to about 2^kScaledPeak. Within a tile, the distance to
/// the nearest line goes from kOnLinePx to kFieldTile at most: a ratio of 2^19, to the power of 8.
template <int kChannels>
float tile_scale(const FieldTables& tables, const View<kChannels>& view) {
  const hn::CappedTag<float, kLineChunk> d;
  auto peak = hn::Set(d, -HUGE_VALF);
  for (size_t i = 0; i < static_cast<size_t>(tables.padded()); i += hn::Lanes(d)) {
    const auto load = [d, i](const PerLine& array) { return hn::LoadU(d, &array[i]); };
    const auto nearest = hn::Max(hn::Sub(load(view.distance), hn::Set(d, static_cast<float>(kRadiusPx))), hn::Zero(d));
    const auto reach = hn::Max(hn::Add(load(tables.a_single), nearest), hn::Set(d, static_cast<float>(kOnLinePx)));
    peak = hn::Max(peak, hn::MulAdd(load(tables.power_single), quick_log2(d, reach), load(tables.scale_single)));
  }
  return static_cast<float>(kScaledPeak) - std::round(hn::GetLane(hn::MaxOfLanes(d, peak)));
}

/// The largest weights over the tile.
template <int kChannels>
void weigh(const FieldTables& tables, const Tile<kChannels>& tile, View<kChannels>& view) {
  const hn::CappedTag<float, kLineChunk> d;
  const auto weigh_group = [&]<WeightKind kKind>(const LineGroup& group) {
    for (size_t i = group.first(); i < group.end(); i += hn::Lanes(d)) {
      const auto distance = hn::LoadU(d, &view.distance[i]);
      const auto nearest = hn::Max(hn::Sub(distance, hn::Set(d, static_cast<float>(kRadiusPx))), hn::Zero(d));
      const auto reach =
          hn::Max(hn::Add(hn::LoadU(d, &tables.a_single[i]), nearest), hn::Set(d, static_cast<float>(kOnLinePx)));
      hn::StoreU(lane_weight<kKind>(d, reach, tables, tile.scale, i), d, &view.weight_most[i]);
    }
  };
  for (const LineGroup& group : tables.groups()) with_kind(group.kind, weigh_group, group);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
