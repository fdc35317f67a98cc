#pragma once
// The peak speed of the processor, as a reference for benchmarks.

#include <cstdint>

namespace morphkit::warp {

/// Runs `rounds` rounds of independent fused multiply-adds on the widest vectors that Highway chooses on this machine.
/// @return  the number of floating-point operations done, two for each lane.
std::int64_t run_fma(std::int64_t rounds);

}  // namespace morphkit::warp
