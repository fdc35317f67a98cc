// The kernel behind LineField::evaluate for two targets at once; see line_field_simd.cpp.

#include "base/kernel_targets.h"
#include "warp/field/line_field_pass.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/field/line_field_pair_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"
#include "warp/field/line_field_pass-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {

int run_pair(const FieldTables& tables, FieldAccuracy accuracy, int first, bool with_values,
             const FieldOutput& output) {
  return (with_values ? run_pass<5> : run_pass<4>)(tables, accuracy, first, output);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit::warp::detail {

HWY_EXPORT(run_pair);

int simd_pair(const FieldTables& tables, FieldAccuracy accuracy, int first, bool with_values,
              const FieldOutput& output) {
  return HWY_DYNAMIC_DISPATCH(run_pair)(tables, accuracy, first, with_values, output);
}

}  // namespace morphkit::warp::detail
#endif  // HWY_ONCE
