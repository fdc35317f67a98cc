// A pass over an area: each tile's plan, its sums, and their way into the maps. Included once per instruction set; the
// guard toggles accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_PASS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_PASS_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_PASS_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_PASS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "hwy/highway.h"
#include "warp/field/line_field_far-inl.h"
#include "warp/field/line_field_near-inl.h"
#include "warp/field/line_field_pass.h"
#include "warp/field/line_field_plan-inl.h"
#include "warp/field/line_field_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Adds the near lines to the sums, in blocks of chunks.
template <int kChannels>
class NearSum {
 public:
  NearSum(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view, Sums<kChannels>& sums,
          Sums<kChannels>& earlier)
      : tables_(tables), tile_(tile), view_(view), sums_(sums), earlier_(earlier) {}

  template <WeightKind kKind>
  void add_plain_lines(std::span<const int> lines) {
    begin_chunk();
    PlainChunk<kChannels> chunk(tables_, tile_, view_, kKind, lines);
    add_plain<kKind>(chunk, lines.size(), sums_);
  }
  template <WeightKind kKind>
  void add_careful_lines(std::span<const int> lines) {
    begin_chunk();
    CarefulChunk<kChannels> chunk(tables_, tile_, view_, lines);
    add_careful<kKind>(chunk, lines.size(), sums_);
  }
  void finish() {
    if (any_earlier_) sums_.add(earlier_);
  }

 private:
  void begin_chunk() {
    if (chunks_ == kChunksPerBlock) put_away();
    ++chunks_;
  }
  void put_away() {
    if (!any_earlier_) earlier_.clear();
    any_earlier_ = true;
    earlier_.add(sums_);
    sums_.clear();
    chunks_ = 0;
  }

  const FieldTables& tables_;
  const Tile<kChannels>& tile_;
  const View<kChannels>& view_;
  Sums<kChannels>& sums_;
  Sums<kChannels>& earlier_;
  int chunks_ = 0;
  bool any_earlier_ = false;
};

/// Calls fn with every kLineChunk of the lines, and with the rest.
template <class Fn>
void for_chunks(std::span<const int> lines, const Fn& fn) {
  for (; !lines.empty(); lines = lines.subspan(std::min<size_t>(kLineChunk, lines.size())))
    fn(lines.first(std::min<size_t>(kLineChunk, lines.size())));
}

template <int kChannels>
void sum_near(const FieldTables& tables, const Plan& plan, NearSum<kChannels>& sum) {
  for (size_t g = 0; g < tables.groups().size(); ++g) {
    const size_t first = tables.groups()[g].first();
    const auto add_group = [&]<WeightKind kKind>() {
      for_chunks(std::span(plan.plain).subspan(first, plan.plain_count[g]),
                 [&](std::span<const int> lines) { sum.template add_plain_lines<kKind>(lines); });
      for_chunks(std::span(plan.careful).subspan(first, plan.careful_count[g]),
                 [&](std::span<const int> lines) { sum.template add_careful_lines<kKind>(lines); });
    };
    with_kind(tables.groups()[g].kind, add_group);
  }
  sum.finish();
}

// ---- From sums to the caller's maps.

/// Rows or columns of a tile, [begin, end).
struct Part {
  int begin, end;
};

/// One bit for each pixel of a row.
using PixelBits = std::uint32_t;
static_assert(kFieldTile == 32);

/// Positions of one row of the tile for one target. The large part of a position, a whole number, is added last, so
/// that it is rounded once.
/// @return  the unsafe pixels: those on a line, and those with too large an error bound.
template <int kChannels>
PixelBits emit_positions(const Tile<kChannels>& tile, const Sums<kChannels>& sums, const Plan& plan, size_t c, int y,
                         float* out) {
  const hn::CappedTag<float, kFieldTile> d;
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  const double ky = y - kHalf;
  const double at_x = tile.x + (tile.base[c] + ky * tile.base_y[c]);
  const double at_y = tile.y + ky + (tile.base[c + 1] + ky * tile.base_y[c + 1]);
  const auto whole_x = set(std::nearbyint(at_x)), whole_y = set(std::nearbyint(at_y));
  const auto rest_x = set(at_x - std::nearbyint(at_x)), rest_y = set(at_y - std::nearbyint(at_y));
  const auto slope_x = set(tile.base_x[c]), slope_y = set(tile.base_x[c + 1]);
  const double steps = kHalf * (std::abs(tile.base_x[c]) + std::abs(tile.base_x[c + 1]));
  PixelBits unsafe = 0;
  for (size_t x = 0; x < kFieldTile; x += hn::Lanes(d)) {
    const size_t pixel = static_cast<size_t>(y) * kFieldTile + x;
    const auto offset = hn::Iota(d, static_cast<float>(x) - kHalf);
    const auto inverse = quick_reciprocal(d, hn::Load(d, sums.weight + pixel));
    const auto part_x = hn::MulAdd(hn::Load(d, sums.channel[c] + pixel), inverse, hn::MulAdd(offset, slope_x, rest_x));
    const auto part_y =
        hn::MulAdd(hn::Load(d, sums.channel[c + 1] + pixel), inverse, hn::MulAdd(offset, slope_y, rest_y));
    const auto position_x = hn::Add(hn::Add(offset, whole_x), part_x);
    const auto position_y = hn::Add(whole_y, part_y);
    hn::StoreInterleaved2(position_x, position_y, d, out + 2 * x);
    if (!plan.any_careful) continue;
    // Both results are rounded to float at the end (together 2^-23 of the position), and the steps before are rounded
    // too. NaN must count as unsafe.
    const auto largest = hn::Add(hn::Max(hn::Abs(position_x), hn::Abs(position_y)), set(steps));
    const auto error =
        hn::MulAdd(largest, set(0x1p-23), hn::MulAdd(hn::Load(d, sums.error + pixel), inverse, set(plan.bound)));
    const auto off_lines = hn::Ge(hn::Load(d, sums.nearest + pixel), set(kSurelyOffLinePx));
    const auto safe = hn::And(hn::Le(error, set(plan.allowed)), off_lines);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(safe), bits);
    PixelBits some = 0;
    std::memcpy(&some, bits, sizeof(some));
    unsafe |= some << x;
  }
  return unsafe;
}

template <int kChannels>
void emit_values(const FieldTables& tables, const Tile<kChannels>& tile, const Sums<kChannels>& sums, int y,
                 Part columns, float* out) {
  constexpr size_t kValue = kChannels - 1;
  for (int x = columns.begin; x < columns.end; ++x) {
    const size_t pixel = static_cast<size_t>(y) * kFieldTile + static_cast<size_t>(x);
    const double mean = static_cast<double>(sums.channel[kValue][pixel] / sums.weight[pixel]);
    *out++ = static_cast<float>(tables.value_from_channel(tile.base[kValue] + mean));
  }
}

/// Takes one pixel from the reference. @param x, y  in the tile. @param at  in the maps.
template <int kChannels>
void ask_reference(const FieldTables& tables, const Tile<kChannels>& tile, int x, int y, cv::Point at,
                   const FieldOutput& output) {
  const double exact_x = tile.x + (x - kHalf);
  const double exact_y = tile.y + (y - kHalf);
  std::array<double, kChannels> exact;
  reference_point(tables, exact_x, exact_y, tile.channels, exact);
  for (size_t c = 0; c + 1 < kChannels; c += 2) {
    output.positions[static_cast<size_t>(tile.channels[c]) / 2](at) = {static_cast<float>(exact_x + exact[c]),
                                                                       static_cast<float>(exact_y + exact[c + 1])};
  }
  if constexpr (kChannels % 2 == 1) (*output.values)(at) = static_cast<float>(tables.value_from_channel(exact.back()));
}

/// Writes a row of the tile to the maps. @return  the number of pixels taken from the reference.
template <int kChannels>
int emit_row(const FieldTables& tables, const Tile<kChannels>& tile, const Sums<kChannels>& sums, const Plan& plan,
             int y, Part columns, cv::Point first, const FieldOutput& output) {
  const bool whole = columns.begin == 0 && columns.end == kFieldTile;
  PixelBits unsafe = 0;
  for (size_t c = 0; c + 1 < kChannels; c += 2) {
    MapPoint* out = &output.positions[static_cast<size_t>(tile.channels[c]) / 2](first);
    float row[2 * kFieldTile];
    unsafe |= emit_positions(tile, sums, plan, c, y, whole ? out->val : row);
    if (!whole) std::copy(row + ptrdiff_t{2} * columns.begin, row + ptrdiff_t{2} * columns.end, out->val);
  }
  if constexpr (kChannels % 2 == 1) emit_values(tables, tile, sums, y, columns, &(*output.values)(first));
  if (unsafe == 0) return 0;
  int asked = 0;
  for (int x = columns.begin; x < columns.end; ++x) {
    if ((unsafe >> x & 1) == 0) continue;
    ask_reference(tables, tile, x, y, {first.x + x - columns.begin, first.y}, output);
    ++asked;
  }
  return asked;
}

/// The buffers of a thread, reused from tile to tile.
template <int kChannels>
struct Workplace {
  View<kChannels> view;
  Plan plan;
  Sums<kChannels> sums, earlier;
};

/// Sums all lines as the plan says.
template <int kChannels>
void sum_lines(const FieldTables& tables, const Tile<kChannels>& tile, Workplace<kChannels>& place) {
  Sums<kChannels>& sums = place.sums;
  if (place.plan.any_far) {
    sum_far(tables, tile, place.view, place.plan.gate, sums);
  } else {
    sums.clear();
  }
  if (place.plan.any_careful) {
    std::fill(std::begin(sums.error), std::end(sums.error), 0.0f);
    std::fill(std::begin(sums.nearest), std::end(sums.nearest), HUGE_VALF);
  }
  NearSum<kChannels> near(tables, tile, place.view, sums, place.earlier);
  sum_near(tables, place.plan, near);
}

/// The bounds that the sums really have.
template <int kChannels>
Expectation found(const Sums<kChannels>& sums) {
  const hn::CappedTag<float, kFieldTile> d;
  auto least = hn::Set(d, HUGE_VALF);
  auto excursion = hn::Zero(d);
  for (size_t i = 0; i < kTilePixels; i += hn::Lanes(d)) {
    const auto weight = hn::Load(d, sums.weight + i);
    least = hn::Min(least, hn::IfThenElseZero(hn::Gt(weight, hn::Zero(d)), weight));  // NaN counts as nothing
    auto largest = hn::Zero(d);
    for (size_t c = 0; c < kChannels; ++c) {
      largest = hn::Max(largest, hn::Abs(hn::Load(d, sums.channel[c] + i)));
    }
    excursion = hn::Max(excursion, hn::Mul(largest, quick_reciprocal(d, weight)));
  }
  return {static_cast<double>(hn::GetLane(hn::MinOfLanes(d, least))),
          static_cast<double>(hn::GetLane(hn::MaxOfLanes(d, excursion)))};
}

/// Plans and sums until the sums meet the expectation: then the bounds hold.
template <int kChannels>
void evaluate_tile(const FieldTables& tables, Tile<kChannels>& tile, FieldAccuracy accuracy,
                   Workplace<kChannels>& place) {
  look_at_lines(tables, tile, place.view);
  measure_from_base(tables, tile, place.view);
  tile.scale = tables.wide_range() ? tile_scale(tables, place.view) : 0.0f;
  weigh(tables, tile, place.view);
  Expectation expectation = expect(tables, tile, place.view);
  constexpr int kTrials = 3;
  for (int trial = 0; trial < kTrials; ++trial) {
    make_plan(tables, tile, place.view, accuracy, expectation, place.plan);
    sum_lines(tables, tile, place);
    if (place.plan.all_careful) return;
    const Expectation truth = found(place.sums);
    if (truth.total_least >= expectation.total_least && truth.excursion <= expectation.excursion) return;
    expectation.total_least = std::min(expectation.total_least, 0.9 * truth.total_least);
    expectation.excursion = std::max(expectation.excursion, 1.1 * truth.excursion);
  }
  treat_all_carefully(tables, place.plan);
  sum_lines(tables, tile, place);
}

template <int kChannels>
int run_tile(const FieldTables& tables, Tile<kChannels>& tile, FieldAccuracy accuracy, Part rows, Part columns,
             const FieldOutput& output, Workplace<kChannels>& place) {
  evaluate_tile(tables, tile, accuracy, place);
  const Sums<kChannels>& sums = place.sums;
  int asked = 0;
  const int left = static_cast<int>(std::floor(tile.x)) - kHalf, top = static_cast<int>(std::floor(tile.y)) - kHalf;
  for (int y = rows.begin; y < rows.end; ++y) {
    const cv::Point first{left + columns.begin - output.area.x, top + y - output.area.y};
    asked += emit_row(tables, tile, sums, place.plan, y, columns, first, output);
  }
  return asked;
}

/// One pass over the area for one or two targets from `first` on, with the values if kChannels is odd. Tiles lie at
/// multiples of kFieldTile for any area.
template <int kChannels>
int run_pass(const FieldTables& tables, FieldAccuracy accuracy, int first, const FieldOutput& output) {
  thread_local Workplace<kChannels> place;
  place.view.resize(static_cast<size_t>(tables.padded()));
  place.plan.resize(static_cast<size_t>(tables.padded()));
  Tile<kChannels> tile{};
  for (int c = 0; c < kChannels; ++c) tile.channels[static_cast<size_t>(c)] = 2 * first + c;
  if constexpr (kChannels % 2 == 1) tile.channels.back() = tables.value_channel();
  const auto tile_begin = [](int at) { return at - (at % kFieldTile + kFieldTile) % kFieldTile; };
  const cv::Rect& area = output.area;
  int asked = 0;
  for (int top = tile_begin(area.y); top < area.y + area.height; top += kFieldTile) {
    const Part rows{std::max(area.y - top, 0), std::min(area.y + area.height - top, kFieldTile)};
    for (int left = tile_begin(area.x); left < area.x + area.width; left += kFieldTile) {
      const Part columns{std::max(area.x - left, 0), std::min(area.x + area.width - left, kFieldTile)};
      tile.x = static_cast<double>(left) + kHalf + 0.5;
      tile.y = static_cast<double>(top) + kHalf + 0.5;
      asked += run_tile(tables, tile, accuracy, rows, columns, output, place);
    }
  }
  return asked;
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
