// Lines whose weights are smooth over a tile: their sums are evaluated at a few nodes and interpolated. Included once
// per instruction set; the guard toggles accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_FAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_FAR_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_FAR_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_FAR_INL_H_
#endif

#include "hwy/highway.h"
#include "warp/field/line_field_near-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kNodes = kFieldNodes;

/// Sums of every quantity (the weight, then the channels) at each node of a square grid.
template <int kChannels, size_t kSide>
struct NodeSums {
  float sum[kChannels + 1][kSide][kSide];
};

/// The same in lanes over lines.
template <int kChannels, size_t kSide>
struct NodeLanes {
  alignas(64) float sum[kChannels + 1][kSide][kSide][kLineChunk];
};

/// The lines of one vector at the nodes.
template <WeightKind kKind, int kChannels, size_t kSide, class D>
HWY_INLINE void add_to_nodes(D d, const FieldTables& tables, const View<kChannels>& view, float scale,
                             const float* gate, const float (&offsets)[kSide], size_t i,
                             NodeLanes<kChannels, kSide>& nodes) {
  using V = hn::Vec<D>;
  const auto load = [d, i](const auto& array) { return hn::LoadU(d, &array[i]); };
  const V along_x = load(tables.along_x_single);
  const V along_y = load(tables.along_y_single);
  const V a = load(tables.a_single);
  const V open = load(gate);
  const V across = load(view.across), before = load(view.before), after = load(view.after);
  for (size_t ky = 0; ky < kSide; ++ky) {
    const V y = hn::Set(d, offsets[ky]);
    const V row_across = hn::MulAdd(y, along_x, across);
    const V row_before = hn::NegMulAdd(y, along_y, before);
    const V row_after = hn::MulAdd(y, along_y, after);
    V row_at[kChannels];
    for (size_t c = 0; c < kChannels; ++c) row_at[c] = hn::MulAdd(y, load(view.slope_y[c]), load(view.at[c]));
    for (size_t kx = 0; kx < kSide; ++kx) {
      const V x = hn::Set(d, offsets[kx]);
      const V node_across = hn::NegMulAdd(x, along_y, row_across);
      const V beyond =
          hn::Max(hn::Max(hn::NegMulAdd(x, along_x, row_before), hn::MulAdd(x, along_x, row_after)), hn::Zero(d));
      const V square = hn::MulAdd(node_across, node_across, hn::MulAdd(beyond, beyond, hn::Set(d, kTinySquarePx)));
      const V reach = plus_twice_root(d, hn::Mul(square, hn::Set(d, 0.25f)), a);
      V weight;
      if constexpr (kKind == WeightKind::kAny) {
        weight = quick_power(d, reach, load(tables.power_single), hn::Add(open, hn::Set(d, scale)));
      } else {
        weight = rooted_weight<kKind>(hn::Mul(open, quick_reciprocal(d, reach)));
      }
      float* sum = nodes.sum[0][ky][kx];
      hn::Store(hn::Add(weight, hn::Load(d, sum)), d, sum);
      for (size_t c = 0; c < kChannels; ++c) {
        sum = nodes.sum[c + 1][ky][kx];
        const V value = hn::MulAdd(x, load(view.slope_x[c]), row_at[c]);
        hn::Store(hn::MulAdd(weight, value, hn::Load(d, sum)), d, sum);
      }
    }
  }
}

/// Interpolates one quantity over the tile: from nodes to columns of nodes in every row, then along the rows.
inline void spread(const float (&nodes)[kNodes][kNodes], float* out) {
  const hn::CappedTag<float, kFieldTile> d;
  const auto& basis = node_table().basis;
  alignas(64) float columns[kNodes][kFieldTile];
  for (size_t j = 0; j < kNodes; ++j) {
    for (size_t y = 0; y < kFieldTile; y += hn::Lanes(d)) {
      auto sum = hn::Mul(hn::Load(d, basis[0] + y), hn::Set(d, nodes[0][j]));
      for (size_t k = 1; k < kNodes; ++k) sum = hn::MulAdd(hn::Load(d, basis[k] + y), hn::Set(d, nodes[k][j]), sum);
      hn::Store(sum, d, columns[j] + y);
    }
  }
  for (size_t row = 0; row < kFieldTile; ++row) {
    for (size_t x = 0; x < kFieldTile; x += hn::Lanes(d)) {
      auto sum = hn::Mul(hn::Load(d, basis[0] + x), hn::Set(d, columns[0][row]));
      for (size_t j = 1; j < kNodes; ++j) sum = hn::MulAdd(hn::Load(d, basis[j] + x), hn::Set(d, columns[j][row]), sum);
      hn::Store(sum, d, out + row * kFieldTile + x);
    }
  }
}

/// Adds the lanes to the sums and clears the lanes.
template <int kChannels, size_t kSide>
void collect(NodeLanes<kChannels, kSide>& nodes, NodeSums<kChannels, kSide>& sums) {
  const hn::CappedTag<float, kLineChunk> d;
  for (size_t quantity = 0; quantity <= kChannels; ++quantity) {
    for (size_t ky = 0; ky < kSide; ++ky) {
      for (size_t kx = 0; kx < kSide; ++kx) {
        const auto lanes = hn::Load(d, nodes.sum[quantity][ky][kx]);
        sums.sum[quantity][ky][kx] += hn::GetLane(hn::SumOfLanes(d, lanes));
      }
    }
  }
  nodes = {};
}

/// Sums over all lines at the nodes of a grid. `gates(group)` gives the root or scale of the group's lines.
template <int kChannels, size_t kSide, class Gates>
NodeSums<kChannels, kSide> sum_at_nodes(const FieldTables& tables, const Tile<kChannels>& tile,
                                        const View<kChannels>& view, const Gates& gates,
                                        const float (&offsets)[kSide]) {
  const hn::CappedTag<float, kLineChunk> d;
  NodeLanes<kChannels, kSide> nodes{};
  NodeSums<kChannels, kSide> sums{};
  const auto add_group = [&]<WeightKind kKind>(const LineGroup& group) {
    for (size_t i = 0; i < static_cast<size_t>(group.count); i += hn::Lanes(d)) {
      if (i > 0 && i % (size_t{kChunksPerBlock} * kLineChunk) == 0) collect(nodes, sums);
      add_to_nodes<kKind>(d, tables, view, tile.scale, gates(group), offsets, group.first() + i, nodes);
    }
  };
  for (const LineGroup& group : tables.groups()) with_kind(group.kind, add_group, group);
  collect(nodes, sums);
  return sums;
}

/// Sets the sums of all lines whose gate is open.
template <int kChannels>
void sum_far(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view, const PerLine& gate,
             Sums<kChannels>& sums) {
  const auto nodes = sum_at_nodes(
      tables, tile, view, [&](const LineGroup&) { return gate.data(); }, node_table().offset);
  spread(nodes.sum[0], sums.weight);
  for (size_t c = 0; c < kChannels; ++c) spread(nodes.sum[c + 1], sums.channel[c]);
}

/// Bounds assumed before a tile is evaluated, and checked afterwards.
struct Expectation {
  double total_least;  ///< sum of weights anywhere in the tile
  double excursion;    ///< px, of the mean of any channel from the base
};

/// From the tile's corners.
template <int kChannels>
Expectation expect(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view) {
  constexpr float kCorners[2] = {-kHalf, kHalf - 1};
  constexpr double kTotalMargin = 0.7, kExcursionMargin = 1.5;
  const auto open = [&](const LineGroup& group) {
    return (group.kind == WeightKind::kAny ? tables.scale_single : tables.root_single).data();
  };
  const auto corners = sum_at_nodes(tables, tile, view, open, kCorners);
  Expectation expectation{HUGE_VAL, 0};
  for (size_t i = 0; i < 4; ++i) {
    const double total = static_cast<double>(corners.sum[0][i / 2][i % 2]);
    expectation.total_least = std::min(expectation.total_least, kTotalMargin * total);
    for (size_t c = 0; c < kChannels; ++c) {
      const double mean = std::abs(static_cast<double>(corners.sum[c + 1][i / 2][i % 2])) / total;
      expectation.excursion = std::max(expectation.excursion, kExcursionMargin * mean);
    }
  }
  return expectation;
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
