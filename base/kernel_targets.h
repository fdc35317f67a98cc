#pragma once
// Which instruction sets Highway compiles the kernels for. Included before hwy/foreach_target.h, in every kernel: all
// then choose the same one on a machine.

// Vectors are kept in arrays, which targets without a fixed vector size do not allow. Such machines have NEON too.
// SSSE3: machines with it and without SSE4 are twenty years old; SSE2 serves them.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3)
