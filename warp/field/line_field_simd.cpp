// The kernel behind LineField::evaluate: square tiles of pixels, float lanes.
//
// What keeps float arithmetic close to the double reference:
//  - Everything affine is evaluated in double once per tile and line, at the tile's middle pixel.
//  - Displacements are relative to a base, an affine guess of the tile's mean, so only their differences are rounded. A
//    single pair or equal pairs are as accurate as in double.
//  - Weights are summed a chunk of lines at a time, and chunks in blocks, so the error of a sum hardly grows with the
//    number of lines.
//  - The part of every line in the error of a tile's means is bounded beforehand. Where that bound is too large,
//    because a line is so near that a float is too coarse for its distance, the line is treated carefully: distances
//    are pairs of floats, and the bound on the error is summed with the weights, pixel by pixel. The reference gives
//    the pixels that lie on a line, and those with an error bound above kFieldTolerancePx.
//
// Adaptive evaluation adds a third treatment: lines whose weight is smooth over the tile are summed at 5 x 5 Chebyshev
// nodes only, and the sums are interpolated. The error of that is bounded for each line (see interpolation_error).
// Lines get this treatment, smallest bound first, while the sum of the bounds stays within the tolerance.

#include "base/kernel_targets.h"
#include "warp/field/line_field_pass.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/field/line_field_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"
#include "warp/field/line_field_pass-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

int run_one(const FieldTables& tables, FieldAccuracy accuracy, int target, bool with_values,
            const FieldOutput& output) {
  return (with_values ? run_pass<3> : run_pass<2>)(tables, accuracy, target, output);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {

HWY_EXPORT(run_one);

int simd_evaluate(const FieldTables& tables, cv::Rect area, FieldAccuracy accuracy, std::span<Map> positions,
                  cv::Mat1f* values) {
  if (area.empty()) return 0;
  if (tables.lines() == 0) {
    for (Map& map : positions) {
      for (int y = 0; y < area.height; ++y) {
        for (int x = 0; x < area.width; ++x) {
          map(y, x) = {static_cast<float>(area.x + static_cast<double>(x) + 0.5),
                       static_cast<float>(area.y + static_cast<double>(y) + 0.5)};
        }
      }
    }
    if (values != nullptr) *values = 0.0f;
    return 0;
  }
  const FieldOutput output{positions, values, area};
  int asked = 0;
  for (int target = 0; target < tables.targets(); target += 2) {
    const bool pair = target + 1 < tables.targets();
    const bool with_values = target == 0 && values != nullptr;
    asked += pair ? simd_pair(tables, accuracy, target, with_values, output)
                  : HWY_DYNAMIC_DISPATCH(run_one)(tables, accuracy, target, with_values, output);
  }
  return asked;
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
