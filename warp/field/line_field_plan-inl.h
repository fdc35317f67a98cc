// How the lines of a tile are treated, and bounds on the resulting error of its means. Included once per instruction
// set; the guard toggles accordingly.
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
#include "warp/field/line_field_far-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Allowed error of each of the two coordinates from rounding and from interpolation. The distance then stays within
/// the tolerance.
struct Tolerance {
  double rounding, interpolation;  // px
};
constexpr Tolerance tolerance_of(FieldAccuracy accuracy) {
  constexpr double kShare = 0.7, kRoundingShare = 0.3;
  if (accuracy == FieldAccuracy::kExact) return {kShare * kFieldTolerancePx, 0};
  return {kShare * kRoundingShare * kAdaptiveTolerancePx, kShare * (1 - kRoundingShare) * kAdaptiveTolerancePx};
}

/// Distances from lines have a relative error of 2^-22; with this margin, pixels on a line are left to the reference.
constexpr double kSurelyOffLinePx = kOnLinePx * (1 + 0x1p-8);

/// Three kinds of lines are treated carefully: a line that a pixel may lie on; a line with a rounding error above this
/// part of the allowed error; a line so much weaker than others of its set that squared coordinates over its root could
/// leave the range of a float.
constexpr double kPlainLinePart = 1.0 / 16;
constexpr float kLeastRoot = 0x1p-20f;
/// An error above any tolerance, px or relative.
constexpr float kTooMuch = 1e30f;

/// How the lines of a tile are treated. Kept from tile to tile.
struct Plan {
  PerLine rounding, interpolation;  // px, bound on a mean's error by plain or far treatment
  PerLine gate;                     // for far lines the root or scale, for others a value that makes the weight 0
  // Indices of the lines with this treatment. Those of the n-th group start at the group's first line.
  std::vector<int> plain, careful;
  std::array<size_t, kWeightKinds> plain_count{}, careful_count{};
  bool any_far = false, any_near = false, any_careful = false, all_careful = false;
  double bound = 0;    // px, of all lines except the careful ones
  double allowed = 0;  // px, of all lines

  void resize(size_t lines) {
    for (PerLine* array : {&rounding, &interpolation, &gate}) array->resize(lines);
    for (auto* numbers : {&plain, &careful}) numbers->resize(lines);
  }
};

/// Bound on the error of a mean by rounding a plain line's weight and channels. Distances: 6 roundings of numbers not
/// above the distance, the tile's diameter and the line's length. The root and the reciprocal: 16 units of roundoff.
/// All of this counts b times; the rest adds 6. The error acts on differences from the mean, not from the base.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V rounding_error(D d, V distance, V length, V reach, V b, V share, V spread, V excursion,
                            float other_units) {
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  const V distance_units =
      hn::Div(hn::Mul(set(6), hn::Add(hn::Add(distance, length), set(2 * kRadiusPx))), hn::Max(reach, set(kOnLinePx)));
  const V units = hn::MulAdd(b, hn::Add(distance_units, set(16)), hn::Set(d, other_units));
  return hn::Mul(hn::Mul(share, set(kUnitRoundoff)), hn::Mul(units, hn::Add(spread, excursion)));
}

/// Bound on the error of a far line's weighted channels by interpolation, relative to its largest weight over the tile,
/// px; see docs/methods.md. Where the weight is a power of an analytic distance, the remainder at n = 5 Chebyshev nodes
/// is proportional to the fifth derivative, (b + 4 over 5) (h / distance)^5, with h half the tile. The distance is the
/// smallest over the tile; the constant is an upper bound on measured errors. A channel that changes over the tile adds
/// the weight's fourth derivative times its slope. At the perpendiculars through the ends of a line, the second
/// derivative of its distance jumps by 1 / distance; the error there is of second order.
/// @param size  px, the largest difference of a channel from the mean. @param turn  px, the part of it from its slopes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V interpolation_error(D d, V distance, V a, V b, V smooth, V before, V after, V size, V turn) {
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  const V half = set(kHalf);
  const V soft = hn::Add(a, distance);
  const V z = hn::Div(half, hn::Max(hn::Sub(distance, half), set(1)));
  const V z2 = hn::Mul(z, z);
  // (b + 3 over 4) is (b + 4 over 5) 5 / (b + 4).
  const V product = hn::Div(hn::Mul(set(5.0 / 16), turn), hn::Add(b, set(4)));
  const V power = hn::Mul(hn::Mul(hn::Mul(z2, z2), smooth), hn::MulAdd(hn::Mul(set(0.07), z), size, product));
  const V jump = hn::Div(hn::Mul(set(0.03 * kHalf * kHalf), b), hn::Mul(soft, hn::Max(distance, set(1))));
  const auto crosses = hn::Lt(hn::Min(hn::Abs(before), hn::Abs(after)), set(kRadiusPx));
  const V error = hn::MulAdd(power, hn::Div(distance, soft), hn::IfThenElseZero(crosses, hn::Mul(jump, size)));
  return hn::IfThenElse(hn::Lt(distance, set(2 * kHalf)), hn::Set(d, kTooMuch), error);
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
      const auto reach = hn::Add(a, nearest);
      const auto off_line = hn::Ge(reach, hn::Set(d, static_cast<float>(kSurelyOffLinePx)));
      const auto share = hn::Mul(load(view.weight_most), inverse_total);
      const auto spread = load(view.spread);
      const auto length = hn::Neg(hn::Add(load(view.before), load(view.after)));
      const auto rounding = rounding_error(d, distance, length, reach, b, hn::Min(share, hn::Set(d, 1.0f)), spread,
                                           excursion, other_units);
      hn::StoreU(hn::IfThenElse(off_line, rounding, hn::Set(d, kTooMuch)), d, &plan.rounding[i]);
      const auto error = interpolation_error(d, distance, a, b, load(tables.smooth_single), load(view.before),
                                             load(view.after), hn::Add(spread, excursion), load(view.turn));
      hn::StoreU(hn::Mul(share, error), d, &plan.interpolation[i]);
    }
  }
}

/// The sum of all interpolation errors below a limit.
inline float sum_below(const FieldTables& tables, const PerLine& errors, float limit) {
  const hn::CappedTag<float, kLineChunk> d;
  auto sum = hn::Zero(d);
  for (const LineGroup& group : tables.groups()) {
    for (size_t i = group.first(); i < group.end(); i += hn::Lanes(d)) {
      const auto error = hn::LoadU(d, &errors[i]);
      const auto counts = hn::And(hn::Lt(error, hn::Set(d, limit)), hn::FirstN(d, group.end() - i));
      sum = hn::Add(sum, hn::IfThenElseZero(counts, error));
    }
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

/// Lines with an interpolation error below this limit are far: their sum is within the tolerance. A power of 2, or 0.
inline float far_limit(const FieldTables& tables, const Plan& plan, double tolerance_px) {
  constexpr int kLeast = -40, kMost = 0;
  const auto power_of_two = [](int exponent) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23);
  };
  int known = kLeast - 1, possible = kMost;  // exponents: surely within; possibly within
  while (known < possible) {
    const int middle = possible - (possible - known) / 2;
    const bool will_do =
        sum_below(tables, plan.interpolation, power_of_two(middle)) <= static_cast<float>(tolerance_px);
    (will_do ? known : possible) = will_do ? middle : middle - 1;
  }
  return known < kLeast ? 0 : power_of_two(known);
}

/// Treats all lines carefully, where plain floats cannot keep the tolerance.
inline void treat_all_carefully(const FieldTables& tables, Plan& plan) {
  for (size_t g = 0; g < tables.groups().size(); ++g) {
    const LineGroup& group = tables.groups()[g];
    plan.plain_count[g] = 0;
    plan.careful_count[g] = static_cast<size_t>(group.count);
    for (int i = 0; i < group.count; ++i) plan.careful[group.first() + static_cast<size_t>(i)] = group.begin + i;
  }
  plan.any_far = false;
  plan.any_near = plan.any_careful = plan.all_careful = true;
  plan.bound = 0;
}

/// Chooses the treatment of every line of a group. @return  a bound on the error of its plain and far lines, px.
inline double plan_group(const FieldTables& tables, size_t number, float limit, double tolerance, Plan& plan) {
  const hn::CappedTag<float, kLineChunk> d;
  const hn::RebindToSigned<decltype(d)> di;
  const LineGroup& group = tables.groups()[number];
  const bool any_power = group.kind == WeightKind::kAny;
  const PerLine& open = any_power ? tables.scale_single : tables.root_single;
  const auto closed = hn::Set(d, any_power ? static_cast<float>(kLeastLog2) : 0.0f);
  const auto plain_most = hn::Set(d, static_cast<float>(kPlainLinePart * tolerance));
  int* plain_end = &plan.plain[group.first()];
  int* careful_end = &plan.careful[group.first()];
  auto bound = hn::Zero(d);
  for (size_t i = group.first(); i < group.end(); i += hn::Lanes(d)) {
    const auto is_line = hn::FirstN(d, group.end() - i);
    const auto rounding = hn::LoadU(d, &plan.rounding[i]);
    const auto far = hn::And(is_line, hn::Lt(hn::LoadU(d, &plan.interpolation[i]), hn::Set(d, limit)));
    const auto holds =
        hn::And(hn::Le(rounding, plain_most), hn::Ge(hn::LoadU(d, &tables.root_single[i]), hn::Set(d, kLeastRoot)));
    const auto near = hn::AndNot(far, is_line);
    const auto numbers = hn::Iota(di, static_cast<std::int32_t>(i));
    hn::StoreU(hn::IfThenElse(far, hn::LoadU(d, &open[i]), closed), d, &plan.gate[i]);
    plain_end += hn::CompressStore(numbers, hn::RebindMask(di, hn::And(near, holds)), di, plain_end);
    careful_end += hn::CompressStore(numbers, hn::RebindMask(di, hn::AndNot(holds, near)), di, careful_end);
    bound = hn::Add(bound, hn::IfThenElseZero(hn::Or(far, hn::And(near, holds)), rounding));
    plan.any_far |= !hn::AllFalse(d, far);
  }
  plan.plain_count[number] = static_cast<size_t>(plain_end - &plan.plain[group.first()]);
  plan.careful_count[number] = static_cast<size_t>(careful_end - &plan.careful[group.first()]);
  plan.any_near |= plan.plain_count[number] + plan.careful_count[number] > 0;
  plan.any_careful |= plan.careful_count[number] > 0;
  // The sum itself is computed in floats.
  return (1 + kLineChunk * kUnitRoundoff * group.count) * static_cast<double>(hn::GetLane(hn::SumOfLanes(d, bound)));
}

template <int kChannels>
void make_plan(const FieldTables& tables, const Tile<kChannels>& tile, const View<kChannels>& view,
               FieldAccuracy accuracy, const Expectation& expectation, Plan& plan) {
  plan.allowed = tolerance_of(accuracy).rounding;
  if (!(expectation.total_least > 0)) return treat_all_carefully(tables, plan);
  bound_errors(tables, view, expectation, plan);
  const Tolerance tolerance = tolerance_of(accuracy);
  const float limit = accuracy == FieldAccuracy::kAdaptive ? far_limit(tables, plan, tolerance.interpolation) : 0;
  plan.any_far = plan.any_near = plan.any_careful = plan.all_careful = false;
  plan.bound = 0;
  for (size_t g = 0; g < tables.groups().size(); ++g)
    plan.bound += plan_group(tables, g, limit, tolerance.rounding, plan);
  // Both results are rounded to float at the end: together 2^-23 of the position.
  double position = 0;
  for (size_t c = 0; c < kChannels; ++c) {
    if (tile.channels[c] == tables.value_channel()) continue;
    const double origin = tile.channels[c] % 2 == 0 ? tile.x : tile.y;
    const double slopes = 1 + std::abs(tile.base_x[c]) + std::abs(tile.base_y[c]);
    position = std::max(position, std::abs(origin + tile.base[c]) + kHalf * slopes + expectation.excursion);
  }
  plan.bound += position * 0x1p-23;
  if (!(plan.bound <= tolerance.rounding)) treat_all_carefully(tables, plan);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#endif
