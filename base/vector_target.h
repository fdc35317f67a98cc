#pragma once
// Which instructions the kernels use.

namespace morphkit {

/// The instruction set that the kernels were chosen for on this machine, as Highway calls it: "AVX3", "NEON", ...
const char* vector_target();

}  // namespace morphkit
