#pragma once
// Pictures against those that people have looked at. Renew with scripts/renew-goldens.sh.

#include <filesystem>
#include <string>

namespace morphkit::test {

/// Expects that a picture file shows what tests/golden/expected/<name>.png shows, within kGoldenTolerance. On failure
/// writes the actual picture, the expected one and their difference to golden-report/ in the build directory. When
/// goldens are renewed, replaces the expected picture if it differs and prints by how much.
void expect_golden(const std::string& name, const std::filesystem::path& actual);

/// The same for every golden picture: instruction sets may differ by kFieldTolerancePx, which moves an 8-bit value by a
/// step, and the rounding of two such values by one more.
inline constexpr double kGoldenTolerance = 2.0 / 255;

}  // namespace morphkit::test
