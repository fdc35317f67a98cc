#include "base/kernel_targets.h"
#include "base/vector_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "base/vector_target_simd.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::detail {
namespace HWY_NAMESPACE {

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace morphkit {
namespace detail {
HWY_EXPORT(target_name);
}

const char* vector_target() {
  return HWY_DYNAMIC_DISPATCH(detail::target_name)();
}

}  // namespace morphkit
#endif  // HWY_ONCE
