#pragma once
// Compares pictures with golden ones, which people have approved. Renew with scripts/renew-goldens.sh.

#include <filesystem>
#include <string>

namespace morphkit::test {

/// Expects that a picture file equals tests/golden/expected/<name>.png within kGoldenTolerance. On failure it writes
/// the actual picture, the expected one and their difference to golden-report/ in the build directory. When goldens are
/// renewed, it replaces the expected picture if it differs and prints the difference.
void expect_golden(const std::string& name, const std::filesystem::path& actual);

/// The same for every golden picture: instruction sets may differ by kFieldTolerancePx, which moves an 8-bit value by a
/// step, and the rounding of two such values by one more.
inline constexpr double kGoldenTolerance = 2.0 / 255;

}  // namespace morphkit::test
