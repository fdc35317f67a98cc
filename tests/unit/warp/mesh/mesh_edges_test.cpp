// The map along a scanline: its properties for any knots, and the same bits on every instruction set that this machine
// runs.

#include "warp/mesh/mesh_curves.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace morphkit::warp {
namespace {

constexpr MeshSpline kSplines[] = {MeshSpline::kMonotone, MeshSpline::kCatmullRom, MeshSpline::kLinear};

struct Case {
  LineKnots knots;
  MeshSpline spline;
  double length;              ///< of the source line
  std::vector<double> edges;  ///< to be filled
};

/// Knots in and out of order and equal ones; outlines inside, around and beside the output line, which has 0 to 67
/// pixels.
Case random_case(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto whole = [&](std::size_t low, std::size_t high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  Case result;
  result.spline = kSplines[seed % 3];
  result.length = static_cast<double>(whole(1, 60));
  result.edges.assign(whole(1, 68), -1);
  result.knots.resize(whole(2, 9));
  for (double& place : result.knots.to) place = between(-20, 80);
  for (double& place : result.knots.from) place = between(-30, result.length + 30);
  if (seed % 2 == 0) std::sort(result.knots.to.begin(), result.knots.to.end());
  if (seed % 4 == 0) std::sort(result.knots.from.begin(), result.knots.from.end());
  if (seed % 5 == 0) result.knots.to[1] = result.knots.to[0];
  if (seed % 7 == 0) result.knots.from = result.knots.to;
  result.knots.prepare(result.spline, result.length);
  return result;
}

class LineEdgesOnTarget : public hwy::TestWithParamTarget {};
HWY_TARGET_INSTANTIATE_TEST_SUITE_P(LineEdgesOnTarget);

TEST_P(LineEdgesOnTarget, RiseWithinTheSourceAndAreTheMapAtWholeNumbers) {
  for (unsigned seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    Case line = random_case(seed);
    line.knots.edges(line.edges);
    std::size_t segment = kUnknown;
    for (std::size_t k = 0; k < line.edges.size(); ++k) {
      ASSERT_TRUE(line.edges[k] >= 0 && line.edges[k] <= line.length);
      ASSERT_GE(line.edges[k], line.edges[k > 0 ? k - 1 : 0] - 1e-9);
      if (line.spline == MeshSpline::kCatmullRom) continue;  // at() keeps the part that turns back
      // The same arithmetic, so the same bits: no target fuses multiplications and additions.
      ASSERT_EQ(line.edges[k], line.knots.at(static_cast<double>(k), segment)) << k;
    }
  }
}

TEST_P(LineEdgesOnTarget, AreWholeNumbersWhereNothingMoves) {
  LineKnots knots;
  knots.resize(5);
  knots.to = knots.from = {0, 3.7, 11.1, 40.3, 67};
  std::vector<double> edges(68);
  for (const MeshSpline spline : kSplines) {
    knots.prepare(spline, 67);
    knots.edges(edges);
    for (std::size_t k = 0; k < edges.size(); ++k) ASSERT_EQ(edges[k], static_cast<double>(k));
  }
}

}  // namespace
}  // namespace morphkit::warp
