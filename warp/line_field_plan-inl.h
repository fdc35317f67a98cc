// How the lines of a tile are treated, and what that can do to its means; on the instruction set that is being
// compiled. Included by warp/line_field_simd.cpp; the guard toggles accordingly.
#if defined(MORPHKIT_WARP_LINE_FIELD_PLAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MORPHKIT_WARP_LINE_FIELD_PLAN_INL_H_
#undef MORPHKIT_WARP_LINE_FIELD_PLAN_INL_H_
#else
#define MORPHKIT_WARP_LINE_FIELD_PLAN_INL_H_
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hwy/highway.h"
#include "warp/line_field_far-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What rounding and interpolation may do to each of the two coordinates, so that their distance keeps to the
/// tolerance.
struct Tolerance {
  double rounding, interpolation;  // px
};
constexpr Tolerance tolerance_of(FieldAccuracy accuracy) {
  constexpr double kShare = 0.7, kRoundingShare = 0.3;
  if (accuracy == FieldAccuracy::kExact) return {kShare * kFieldTolerancePx, 0};
  return {kShare * kRoundingShare * kAdaptiveTolerancePx, kShare * (1 - kRoundingShare) * kAdaptiveTolerancePx};
}

/// A line whose rounding alone could take this part of what is allowed is treated carefully; so is one so much weaker
/// than others of its set that the squares of coordinates over its root could leave the range of a float.
constexpr double kPlainLinePart = 1.0 / 16;
constexpr float kLeastRoot = 0x1p-20f;

enum class Treatment : std::uint8_t { kPlain, kCareful, kFar };

/// How the lines of a tile are treated. Kept from tile to tile.
struct Plan {
  PerLine rounding, interpolation;  // px, what plain or far treatment of a line could do to a coordinate of a mean
  std::vector<Treatment> treatment;
  PerLine gate;  // for far lines the root or scale, for others what makes their weight 0
  bool any_far = false, any_careful = false, all_careful = false;
  double bound = 0;    // px, of all lines but the careful
  double allowed = 0;  // px, of all lines

  void resize(size_t lines) {
    for (PerLine* array : {&rounding, &interpolation, &gate}) array->resize(lines);
    treatment.resize(lines);
  }
};

/// What the rounding of a plain line's weight and channels can do to a mean. Distances: 6 roundings of numbers not
/// above the distance, the tile's diameter and the line's length; the root and the reciprocal: 16 units of roundoff;
/// all of it b times, and 6 for the rest; it acts on differences from the mean rather than the base.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V rounding_error(D d, V distance, V length, V reach, V b, V share, V spread, V excursion,
                            float other_units) {
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  const V distance_units =
      hn::Div(hn::Mul(set(6), hn::Add(hn::Add(distance, length), set(2 * kRadiusPx))), hn::Max(reach, set(kOnLinePx)));
  const V units = hn::MulAdd(b, hn::Add(distance_units, set(16)), hn::Set(d, other_units));
  return hn::Mul(hn::Mul(share, set(kUnitRoundoff)), hn::Mul(units, hn::Add(spread, excursion)));
}

/// What interpolation of a far line's weight can do to it, relative to its largest value over the tile; see
/// docs/methods.md. Where the weight is a power of an analytic distance, the remainder of interpolation at n = 5
/// Chebyshev nodes goes with the fifth derivative, (b + 4 over 5) (h / distance)^5, h being half the tile; the distance
/// is measured to where it is nearest, and the constant is an upper bound of what is measured. At the perpendiculars
/// through its ends a line's distance has a second derivative that jumps by 1 / distance, for which the error is of
/// second order.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V interpolation_error(D d, V distance, V a, V b, V smooth, V before, V after) {
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  const V half = set(kHalf);
  const V soft = hn::Add(a, distance);
  const V z = hn::Div(half, hn::Max(hn::Sub(distance, half), set(1)));
  const V z2 = hn::Mul(z, z);
  const V analytic = hn::Mul(hn::Mul(set(0.07), smooth), hn::Div(hn::Mul(hn::Mul(z2, z2), hn::Mul(z, distance)), soft));
  const V jump = hn::Div(hn::Mul(set(0.03 * kHalf * kHalf), b), hn::Mul(soft, hn::Max(distance, set(1))));
  const auto crosses = hn::Lt(hn::Min(hn::Abs(before), hn::Abs(after)), set(kRadiusPx));
  const V error = hn::Add(analytic, hn::IfThenElseZero(crosses, jump));
  return hn::IfThenElse(hn::Lt(distance, set(2 * kHalf)), set(1e30), error);
}

template <int kChannels>
void bound_errors(const FieldTables& tables, const View<kChannels>& view, const Expectation& expectation, Plan& plan) {
  const hn::CappedTag<float, kLineChunk> d;
  const auto excursion = hn::Set(d, static_cast<float>(expectation.excursion));
  const auto inverse_total = hn::Set(d, static_cast<float>(1 / expectation.total_least));
  for (const LineGroup& group : tables.groups()) {
    const double power_units = group.kind == WeightKind::kAny ? kQuickPowerUnits : 0;
    const auto other_units = static_cast<float>(6 + power_units + sum_units(tables) + 3);
    for (size_t i = group.first(); i < group.end(); i += hn::Lanes(d)) {
      const auto load = [d, i](const PerLine& array) { return hn::LoadU(d, &array[i]); };
      const auto a = load(tables.a_single);
      const auto b = hn::Neg(load(tables.power_single));
      const auto distance = load(view.distance);
      const auto nearest = hn::Max(hn::Sub(distance, hn::Set(d, static_cast<float>(kRadiusPx))), hn::Zero(d));
      const auto share = hn::Mul(load(view.weight_most), inverse_total);
      const auto spread = load(view.spread);
      const auto length = hn::Neg(hn::Add(load(view.before), load(view.after)));
      hn::StoreU(rounding_error(d, distance, length, hn::Add(a, nearest), b, hn::Min(share, hn::Set(d, 1.0f)), spread,
                                excursion, other_units),
                 d, &plan.rounding[i]);
      const auto relative =
          interpolation_error(d, distance, a, b, load(tables.smooth_single), load(view.before), load(view.after));
      hn::StoreU(hn::Mul(hn::Mul(share, relative), hn::Add(spread, excursion)), d, &plan.interpolation[i]);
    }
  }
}

/// The exponent e of a positive normal float below 2^e and at least 2^(e - 1).
int exponent_of(float value) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(value) >> 23) - 126;
}

/// The interpolation error up to which lines are far: their sum stays within the tolerance. A power of 2, or 0.
float far_limit(const FieldTables& tables, const Plan& plan, double tolerance_px) {
  constexpr int kLeast = -40, kMost = 0;
  std::array<float, kMost - kLeast + 1> sums{};
  for (const LineGroup& group : tables.groups()) {
    for (size_t i = group.first(); i < group.end(); ++i) {
      const float error = plan.interpolation[i];
      if (error < 1) sums[static_cast<size_t>(std::max(exponent_of(error), kLeast) - kLeast)] += error;
    }
  }
  float sum = 0;
  float limit = 0;
  for (int exponent = kLeast; exponent <= kMost; ++exponent) {
    sum += sums[static_cast<size_t>(exponent - kLeast)];
    if (!(sum <= static_cast<float>(tolerance_px))) break;
    limit = std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23);  // 2^exponent
  }
  return limit;
}

/// Everything with care, where what is asked for is more than plain floats can promise.
void treat_all_carefully(Plan& plan) {
  std::fill(plan.treatment.begin(), plan.treatment.end(), Treatment::kCareful);
  plan.any_far = false;
  plan.any_careful = plan.all_careful = true;
  plan.bound = 0;
}

template <int kChannels>
void make_plan(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view,
               FieldAccuracy accuracy, const Expectation& expectation, Plan& plan) {
  plan.allowed = tolerance_of(accuracy).rounding;
  if (!(expectation.total_least > 0)) return treat_all_carefully(plan);
  bound_errors(tables, view, expectation, plan);
  const Tolerance tolerance = tolerance_of(accuracy);
  const float limit = accuracy == FieldAccuracy::kAdaptive ? far_limit(tables, plan, tolerance.interpolation) : 0;
  plan.any_far = plan.any_careful = plan.all_careful = false;
  plan.bound = 0;
  for (const LineGroup& group : tables.groups()) {
    const bool any_power = group.kind == WeightKind::kAny;
    const PerLine& open = any_power ? tables.scale_single : tables.root_single;
    for (size_t i = group.first(); i < group.end(); ++i) {
      const bool far = plan.interpolation[i] < limit;
      const bool plain = static_cast<double>(plan.rounding[i]) <= kPlainLinePart * tolerance.rounding &&
                         tables.root_single[i] >= kLeastRoot;
      plan.treatment[i] = far ? Treatment::kFar : plain ? Treatment::kPlain : Treatment::kCareful;
      plan.gate[i] = far ? open[i] : any_power ? static_cast<float>(kLeastLog2) : 0.0f;
      plan.any_far |= far;
      plan.any_careful |= !far && !plain;
      if (far || plain) plan.bound += static_cast<double>(plan.rounding[i]);
    }
    for (size_t i = group.end(); i < group.padded_end(); ++i)
      plan.gate[i] = any_power ? static_cast<float>(kLeastLog2) : 0.0f;
  }
  // Both results are rounded to float at the end: 2^-23 of the position between them.
  double position = 0;
  for (size_t c = 0; c < kChannels; ++c) {
    if (tile.channels[c] == tables.value_channel()) continue;
    const double origin = tile.channels[c] % 2 == 0 ? tile.x : tile.y;
    const double slopes = 1 + std::abs(tile.base_x[c]) + std::abs(tile.base_y[c]);
    position = std::max(position, std::abs(origin + tile.base[c]) + kHalf * slopes + expectation.excursion);
  }
  plan.bound += position * 0x1p-23;
  if (!(plan.bound <= tolerance.rounding)) treat_all_carefully(plan);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
