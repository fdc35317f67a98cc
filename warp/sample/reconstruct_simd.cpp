// The kernel behind reconstruct_row: positions become addresses and weights a batch at a time, in lanes over pixels;
// then every pixel is summed in lanes over taps and channels, while the taps of the next batch are fetched.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/kernel_targets.h"
#include "warp/sample/reconstruct.h"
#include "warp/sample/reconstruct_border.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/sample/reconstruct_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void run_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
             std::span<Pixel> out) {
  reference_reconstruct_row(source, positions, kernel, border, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

/// Pixels that are prepared together. A row of a warp crosses many source rows, which the hardware cannot predict; taps
/// are fetched this many pixels ahead of their use.
constexpr size_t kBatch = 64;

/// Sums are written this many pixels at a time.
constexpr size_t kGroup = 4;

/// How a pixel is computed.
enum Fate : int32_t { kPlain, kOnCentre, kAtBorder };

struct Batch {
  const uint8_t* tap[kBatch];  // the first
  alignas(64) int32_t x[kBatch], y[kBatch], fate[kBatch];
  // Bilinear: the fractions, and room for a vector that begins at the last one. Bicubic: four rows of kBatch; the row
  // of tap 1 is not used.
  alignas(64) float across[4 * kBatch + 16], down[4 * kBatch];
  bool any_special, all_special;
};

/// The source, and the area of positions with all taps inside: there the border does not matter. Counted from the point
/// at which a pixel's place is [i, i + 1).
struct Area {
  const uint8_t* data;
  size_t step;
  float begin, end_x, end_y;
};

template <class Taps>
Area area_of(const Image& source) {
  constexpr int kAfter = Taps::kTaps - 1 - Taps::kBefore;
  // Positions below 2^22 are exact to a quarter pixel and better: counting from centres loses nothing.
  const auto end = [](int size) { return static_cast<float>(std::min(size - kAfter, 1 << 22)); };
  return {source.data, source.step[0], static_cast<float>(Taps::kBefore), end(source.cols), end(source.rows)};
}

using Lanes = hn::CappedTag<float, 16>;
using Lane = hn::Vec<Lanes>;

// A kernel's taps are kTaps x kTaps; the first lies kBefore pixels left of and above the position's floor.

struct NearestTaps {
  static constexpr int kTaps = 1;
  static constexpr int kBefore = 0;
  static constexpr float kCentre = 0;

  static HWY_INLINE void weigh(Lane, size_t, float*) {}
  static HWY_INLINE void sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out);
};

struct BilinearTaps {
  static constexpr int kTaps = 2;
  static constexpr int kBefore = 0;
  static constexpr float kCentre = 0.5F;

  static HWY_INLINE void weigh(Lane fraction, size_t i, float* to) { hn::Store(fraction, Lanes(), to + i); }
  static HWY_INLINE void sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out);
};

struct BicubicTaps {
  static constexpr int kTaps = 4;
  static constexpr int kBefore = 1;
  static constexpr float kCentre = 0.5F;

  /// Tap 1 has no weight: the weighted differences are taken from it.
  static HWY_INLINE void weigh(Lane f, size_t i, float* to) {
    const Lanes d;
    const Lane one = hn::Set(d, 1.0F);
    const Lane half = hn::Set(d, 0.5F);
    const Lane w0 = hn::Mul(f, hn::Sub(hn::Mul(f, hn::Sub(one, hn::Mul(half, f))), half));
    const Lane w2 = hn::Mul(f, hn::Add(hn::Mul(f, hn::Sub(hn::Set(d, 2.0F), hn::Mul(hn::Set(d, 1.5F), f))), half));
    const Lane w3 = hn::Mul(hn::Mul(hn::Mul(half, f), f), hn::Sub(f, one));
    hn::Store(w0, d, to + i);
    hn::Store(w2, d, to + 2 * kBatch + i);
    hn::Store(w3, d, to + 3 * kBatch + i);
  }
  static HWY_INLINE void sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out);
};

/// Turns positions into places, fates and weights. Pixels that are not plain get some existing taps.
template <class Taps>
HWY_INLINE void prepare(const Area& area, const MapPoint* positions, Batch& batch) {
  const Lanes d;
  const hn::RebindToSigned<Lanes> di;
  const Lane begin = hn::Set(d, area.begin);
  const Lane centre = hn::Set(d, Taps::kCentre);
  auto any = hn::Zero(di);
  auto all = hn::Set(di, -1);
  for (size_t i = 0; i < kBatch; i += hn::Lanes(d)) {
    Lane x, y;
    hn::LoadInterleaved2(d, positions->val + 2 * i, x, y);
    x = hn::Sub(x, centre);
    y = hn::Sub(y, centre);
    // False for NaN.
    const auto inside = hn::And(hn::And(hn::Ge(x, begin), hn::Lt(x, hn::Set(d, area.end_x))),
                                hn::And(hn::Ge(y, begin), hn::Lt(y, hn::Set(d, area.end_y))));
    x = hn::IfThenElse(inside, x, begin);
    y = hn::IfThenElse(inside, y, begin);
    const auto column = hn::ConvertTo(di, x);
    const auto row = hn::ConvertTo(di, y);
    const Lane fraction_x = hn::Sub(x, hn::ConvertTo(d, column));
    const Lane fraction_y = hn::Sub(y, hn::ConvertTo(d, row));
    const auto centred = hn::VecFromMask(di, hn::RebindMask(di, hn::Eq(hn::Or(fraction_x, fraction_y), hn::Zero(d))));
    const auto on_centre = Taps::kTaps == 1 ? hn::Zero(di) : hn::And(centred, hn::Set(di, kOnCentre));
    const auto fate = hn::IfThenElse(hn::RebindMask(di, inside), on_centre, hn::Set(di, kAtBorder));
    any = hn::Or(any, fate);
    all = hn::And(all, hn::VecFromMask(di, hn::Ne(fate, hn::Zero(di))));
    hn::Store(fate, di, batch.fate + i);
    hn::Store(hn::Sub(column, hn::Set(di, Taps::kBefore)), di, batch.x + i);
    hn::Store(hn::Sub(row, hn::Set(di, Taps::kBefore)), di, batch.y + i);
    Taps::weigh(fraction_x, i, batch.across);
    Taps::weigh(fraction_y, i, batch.down);
  }
  batch.any_special = !hn::AllTrue(di, hn::Eq(any, hn::Zero(di)));
  batch.all_special = hn::AllTrue(di, hn::Ne(all, hn::Zero(di)));
  for (size_t i = 0; i < kBatch; ++i) {
    batch.tap[i] =
        area.data + static_cast<size_t>(batch.y[i]) * area.step + static_cast<size_t>(batch.x[i]) * sizeof(Pixel);
  }
}

/// Going down the output, the lowest row of taps is usually not in the cache yet.
template <class Taps>
HWY_INLINE void fetch(const Batch& next, size_t i, size_t step) {
  __builtin_prefetch(next.tap[i] + (Taps::kTaps - 1) * (step + sizeof(Pixel)));
}

HWY_INLINE const float* floats(const uint8_t* pixel) {
  return reinterpret_cast<const float*>(pixel);
}

HWY_INLINE void NearestTaps::sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out) {
  const hn::FixedTag<float, 4> d;
  for (size_t i = 0; i < count; ++i) {
    fetch<NearestTaps>(next, i, step);
    hn::StoreU(hn::LoadU(d, floats(batch.tap[i])), d, out[i].val);
  }
}

/// One row of two taps is as long as a vector of AVX2.
HWY_INLINE void BilinearTaps::sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out) {
  const hn::CappedTag<float, 8> d;
  using V = hn::Vec<decltype(d)>;
  const auto between = [](V a, V b, V weight) HWY_ATTR { return hn::Add(a, hn::Mul(weight, hn::Sub(b, a))); };
  const auto column = [&](size_t i, size_t offset) HWY_ATTR {
    const uint8_t* tap = batch.tap[i] + offset;
    return between(hn::LoadU(d, floats(tap)), hn::LoadU(d, floats(tap + step)), hn::Set(d, batch.down[i]));
  };
  if constexpr (hn::MaxLanes(hn::CappedTag<float, 8>()) == 8) {
    alignas(32) constexpr int32_t kExpand[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const auto expand = hn::SetTableIndices(d, kExpand);
    for (size_t i = 0; i < count; i += 2) {
      fetch<BilinearTaps>(next, i, step);
      fetch<BilinearTaps>(next, i + 1, step);
      const V a = column(i, 0);
      const V b = column(i + 1, 0);
      const V weight = hn::TableLookupLanes(hn::LoadU(d, batch.across + i), expand);
      hn::StoreU(between(hn::ConcatLowerLower(d, b, a), hn::ConcatUpperUpper(d, b, a), weight), d, out[i].val);
    }
  } else {
    for (size_t i = 0; i < count; ++i) {
      fetch<BilinearTaps>(next, i, step);
      const V weight = hn::Set(d, batch.across[i]);
      hn::StoreU(between(column(i, 0), column(i, sizeof(Pixel)), weight), d, out[i].val);
    }
  }
}

/// A row of four taps in as many vectors as it needs.
constexpr size_t kRowLanes = hn::MaxLanes(Lanes());
constexpr size_t kRowVectors = 16 / kRowLanes;

HWY_INLINE void bicubic_columns(const uint8_t* tap, size_t step, const float* weights, Lane (&columns)[kRowVectors]) {
  const Lanes d;
  const Lane w0 = hn::Set(d, weights[0]);
  const Lane w2 = hn::Set(d, weights[2 * kBatch]);
  const Lane w3 = hn::Set(d, weights[3 * kBatch]);
  for (size_t v = 0; v < kRowVectors; ++v, tap += kRowLanes * sizeof(float)) {
    const Lane centre = hn::LoadU(d, floats(tap + step));
    const Lane d0 = hn::Sub(hn::LoadU(d, floats(tap)), centre);
    const Lane d2 = hn::Sub(hn::LoadU(d, floats(tap + 2 * step)), centre);
    const Lane d3 = hn::Sub(hn::LoadU(d, floats(tap + 3 * step)), centre);
    columns[v] = hn::Add(centre, hn::Add(hn::Mul(w0, d0), hn::Add(hn::Mul(w2, d2), hn::Mul(w3, d3))));
  }
}

/// The weighted sum of four pixels' columns, for each pixel as (0 + 2) + (1 + 3). The other columns are relative to
/// column 1, which is added unchanged.
#if HWY_MAX_BYTES >= 64

/// Weight k of four pixels, each for its own block.
HWY_INLINE Lane four_weights(const float* weights) {
  const Lanes d;
  const hn::Repartition<uint8_t, Lanes> d8;
  // Block k repeats float k of a block.
  alignas(64) constexpr uint32_t kExpand[16] = {0x03020100, 0x03020100, 0x03020100, 0x03020100, 0x07060504, 0x07060504,
                                                0x07060504, 0x07060504, 0x0B0A0908, 0x0B0A0908, 0x0B0A0908, 0x0B0A0908,
                                                0x0F0E0D0C, 0x0F0E0D0C, 0x0F0E0D0C, 0x0F0E0D0C};
  const hn::RebindToUnsigned<Lanes> du;
  const auto packed = hn::BitCast(d8, hn::LoadDup128(d, weights));
  return hn::BitCast(d, hn::TableLookupBytes(packed, hn::BitCast(d8, hn::Load(du, kExpand))));
}

/// Transposed, so that a vector holds the same column of all four.
HWY_INLINE void bicubic_four(const Batch& batch, size_t i, size_t step, const Lane& low, const Lane& high, float* out) {
  const Lanes d;
  Lane pixel[4][1];
  for (size_t k = 0; k < 4; ++k) bicubic_columns(batch.tap[i + k], step, batch.down + i + k, pixel[k]);
  const Lane even_01 = hn::ConcatLowerLower(d, pixel[2][0], pixel[0][0]);
  const Lane even_23 = hn::ConcatUpperUpper(d, pixel[2][0], pixel[0][0]);
  const Lane odd_01 = hn::ConcatLowerLower(d, pixel[3][0], pixel[1][0]);
  const Lane odd_23 = hn::ConcatUpperUpper(d, pixel[3][0], pixel[1][0]);
  const Lane column_0 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd_01), even_01);
  const Lane column_1 = hn::OddEvenBlocks(odd_01, hn::SwapAdjacentBlocks(even_01));
  const Lane column_2 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd_23), even_23);
  const Lane column_3 = hn::OddEvenBlocks(odd_23, hn::SwapAdjacentBlocks(even_23));
  const auto term = [&](size_t k, const Lane& column) HWY_ATTR {
    return hn::Mul(four_weights(batch.across + k * kBatch + i), hn::Sub(column, column_1));
  };
  const Lane sum = hn::Add(hn::Add(term(0, column_0), term(2, column_2)), hn::Add(column_1, term(3, column_3)));
  hn::StoreU(hn::Min(high, hn::Max(low, sum)), d, out);
}

#elif HWY_MAX_BYTES >= 32

/// Weight k of the first or last two of the four pixels in `weights`, each for its own block.
HWY_INLINE Lane two_weights(const float* weights, bool last) {
  const Lanes d;
  const hn::Repartition<uint8_t, Lanes> d8;
  const hn::RebindToUnsigned<Lanes> du;
  alignas(32) constexpr uint32_t kExpand[8] = {0x03020100, 0x03020100, 0x03020100, 0x03020100,
                                               0x07060504, 0x07060504, 0x07060504, 0x07060504};
  const auto expand = hn::Add(hn::BitCast(d8, hn::Load(du, kExpand)), hn::Set(d8, last ? uint8_t{8} : uint8_t{0}));
  return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(d8, hn::LoadDup128(d, weights)), expand));
}

/// Transposed, so that a vector holds the same column of two.
HWY_INLINE void bicubic_four(const Batch& batch, size_t i, size_t step, const Lane& low, const Lane& high, float* out) {
  const Lanes d;
  for (size_t k = 0; k < 4; k += 2) {
    Lane a[2], b[2];
    bicubic_columns(batch.tap[i + k], step, batch.down + i + k, a);
    bicubic_columns(batch.tap[i + k + 1], step, batch.down + i + k + 1, b);
    const Lane columns[4] = {hn::ConcatLowerLower(d, b[0], a[0]), hn::ConcatUpperUpper(d, b[0], a[0]),
                             hn::ConcatLowerLower(d, b[1], a[1]), hn::ConcatUpperUpper(d, b[1], a[1])};
    const auto term = [&](size_t j) HWY_ATTR {
      return hn::Mul(two_weights(batch.across + j * kBatch + i, k == 2), hn::Sub(columns[j], columns[1]));
    };
    const Lane sum = hn::Add(hn::Add(term(0), term(2)), hn::Add(columns[1], term(3)));
    hn::StoreU(hn::Min(high, hn::Max(low, sum)), d, out + 4 * k);
  }
}

#else

HWY_INLINE void bicubic_four(const Batch& batch, size_t i, size_t step, const Lane& low, const Lane& high, float* out) {
  const Lanes d;
  for (size_t k = 0; k < 4; ++k) {
    Lane columns[4];
    bicubic_columns(batch.tap[i + k], step, batch.down + i + k, columns);
    const auto term = [&](size_t j) HWY_ATTR {
      return hn::Mul(hn::Set(d, batch.across[j * kBatch + i + k]), hn::Sub(columns[j], columns[1]));
    };
    const Lane sum = hn::Add(hn::Add(term(0), term(2)), hn::Add(columns[1], term(3)));
    hn::StoreU(hn::Min(high, hn::Max(low, sum)), d, out + 4 * k);
  }
}

#endif

HWY_INLINE void BicubicTaps::sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out) {
  const Lanes d;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  alignas(16) constexpr float kLow[4] = {-kInfinity, -kInfinity, -kInfinity, 0};
  alignas(16) constexpr float kHigh[4] = {kInfinity, kInfinity, kInfinity, 1};
  const Lane low = hn::LoadDup128(d, kLow);
  const Lane high = hn::LoadDup128(d, kHigh);
  for (size_t i = 0; i < count; i += 4) {
    for (size_t k = i; k < i + 4; ++k) fetch<BicubicTaps>(next, k, step);
    bicubic_four(batch, i, step, low, high, out[i].val);
  }
}

template <class Taps>
class Row {
 public:
  Row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border, std::span<Pixel> out)
      : source_(source),
        area_(area_of<Taps>(source)),
        positions_(positions),
        kernel_(kernel),
        border_(border),
        out_(out) {}

  void run() {
    if (!(area_.begin < area_.end_x && area_.begin < area_.end_y)) {
      return reference_reconstruct_row(source_, positions_, kernel_, border_, out_);
    }
    Batch batches[2];
    prepare_at(0, batches[0]);
    const size_t n = positions_.size();
    for (size_t i = 0, k = 0; i < n; i += kBatch, ++k) {
      const Batch& batch = batches[k % 2];
      Batch& next = batches[(k + 1) % 2];
      if (i + kBatch < n) prepare_at(i + kBatch, next);
      finish_at(i, batch, i + kBatch < n ? next : batch);
    }
  }

 private:
  void prepare_at(size_t i, Batch& batch) const {
    if (i + kBatch <= positions_.size()) return prepare<Taps>(area_, positions_.data() + i, batch);
    MapPoint padded[kBatch];
    const auto end = std::copy(positions_.begin() + static_cast<ptrdiff_t>(i), positions_.end(), padded);
    std::fill(end, std::end(padded), positions_.back());
    prepare<Taps>(area_, padded, batch);
  }

  void finish_at(size_t i, const Batch& batch, const Batch& next) const {
    const size_t count = std::min(kBatch, out_.size() - i);
    if (!batch.all_special) sum(batch, next, area_.step, count, out_.data() + i);
    if (batch.any_special) finish_special(i, count, batch);
  }

  static void sum(const Batch& batch, const Batch& next, size_t step, size_t count, Pixel* out) {
    if (count % kGroup == 0) return Taps::sum(batch, next, step, count, out);
    Pixel padded[kBatch];
    Taps::sum(batch, next, step, (count + kGroup - 1) / kGroup * kGroup, padded);
    std::copy(padded, padded + count, out);
  }

  void finish_special(size_t i, size_t count, const Batch& batch) const {
    bool any_at_border = false;
    for (size_t k = 0; k < count; ++k) {
      if (batch.fate[k] == kOnCentre) {
        std::memcpy(out_[i + k].val, batch.tap[k] + Taps::kBefore * (area_.step + sizeof(Pixel)), sizeof(Pixel));
      }
      any_at_border = any_at_border || batch.fate[k] == kAtBorder;
    }
    if (any_at_border) finish_border(i, count, batch);
  }

  /// Taps that lie side by side although the source's do not.
  struct GatheredTaps {
    Batch batch;
    alignas(64) float fraction_x[kBatch], fraction_y[kBatch];
    size_t pixel[kBatch];
    size_t count = 0;
    Pixel taps[kBatch][Taps::kTaps * Taps::kTaps];
  };

  HWY_NOINLINE void finish_border(size_t i, size_t count, const Batch& batch) const {
    GatheredTaps gathered;
    for (size_t k = 0; k < count; ++k) {
      if (batch.fate[k] == kAtBorder) gather(i + k, gathered);
    }
    if (gathered.count == 0) return;
    const size_t rounded = (gathered.count + kGroup - 1) / kGroup * kGroup;
    for (size_t k = 0; k < kBatch; ++k) {
      gathered.batch.tap[k] = reinterpret_cast<const uint8_t*>(gathered.taps[std::min(k, gathered.count - 1)]);
      if (k >= gathered.count) gathered.fraction_x[k] = gathered.fraction_y[k] = 0;
    }
    const Lanes d;
    for (size_t k = 0; k < kBatch; k += hn::Lanes(d)) {
      Taps::weigh(hn::Load(d, gathered.fraction_x + k), k, gathered.batch.across);
      Taps::weigh(hn::Load(d, gathered.fraction_y + k), k, gathered.batch.down);
    }
    Pixel result[kBatch];
    Taps::sum(gathered.batch, gathered.batch, Taps::kTaps * sizeof(Pixel), rounded, result);
    for (size_t k = 0; k < gathered.count; ++k) out_[gathered.pixel[k]] = result[k];
  }

  /// Adds the taps of a position anywhere, or writes its colour if they are not needed.
  void gather(size_t i, GatheredTaps& gathered) const {
    out_[i] = Pixel::all(0);
    const MapPoint& position = positions_[i];
    if (!std::isfinite(position[0]) || !std::isfinite(position[1])) return;
    const Place x = place(static_cast<double>(position[0]) - Taps::kCentre, source_.cols, border_);
    const Place y = place(static_cast<double>(position[1]) - Taps::kCentre, source_.rows, border_);
    int columns[Taps::kTaps];
    int rows[Taps::kTaps];
    bool any_column = false;
    bool any_row = false;
    for (int t = 0; t < Taps::kTaps; ++t) {
      columns[t] = index_within(x.base - Taps::kBefore + t, source_.cols, border_);
      rows[t] = index_within(y.base - Taps::kBefore + t, source_.rows, border_);
      any_column = any_column || columns[t] >= 0;
      any_row = any_row || rows[t] >= 0;
    }
    if (!any_column || !any_row) return;
    const auto pixel_at = [this](int column, int row) {
      return column < 0 || row < 0 ? Pixel::all(0) : source_(row, column);
    };
    if (Taps::kTaps == 1 || (x.fraction == 0 && y.fraction == 0)) {
      out_[i] = pixel_at(columns[Taps::kBefore], rows[Taps::kBefore]);
      return;
    }
    Pixel* tap = gathered.taps[gathered.count];
    for (const int row : rows) {
      for (const int column : columns) *tap++ = pixel_at(column, row);
    }
    gathered.fraction_x[gathered.count] = x.fraction;
    gathered.fraction_y[gathered.count] = y.fraction;
    gathered.pixel[gathered.count++] = i;
  }

  const Image& source_;
  Area area_;
  std::span<const MapPoint> positions_;
  Kernel kernel_;
  Border border_;
  std::span<Pixel> out_;
};

void run_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
             std::span<Pixel> out) {
  switch (kernel) {
    case Kernel::kNearest:
      return Row<NearestTaps>(source, positions, kernel, border, out).run();
    case Kernel::kBilinear:
      return Row<BilinearTaps>(source, positions, kernel, border, out).run();
    case Kernel::kBicubic:
      return Row<BicubicTaps>(source, positions, kernel, border, out).run();
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {

HWY_EXPORT(run_row);

void reconstruct_row(const Image& source, std::span<const MapPoint> positions, Kernel kernel, Border border,
                     std::span<Pixel> out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  if (!out.empty()) HWY_DYNAMIC_DISPATCH(run_row)(source, positions, kernel, border, out);
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
