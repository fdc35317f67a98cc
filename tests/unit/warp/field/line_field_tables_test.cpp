// What the kernel reads: the nodes of a tile and the polynomials between them.

#include "warp/field/line_field_tables.h"

#include <cmath>

#include <gtest/gtest.h>

namespace morphkit::warp {
namespace {

TEST(NodeTable, InterpolatesPolynomialsUpToItsDegreeExactly) {
  const detail::NodeTable& table = detail::node_table();
  for (int degree = 0; degree < detail::kFieldNodes; ++degree) {
    for (int k = 0; k < kFieldTile; ++k) {
      double sum = 0;
      for (int j = 0; j < detail::kFieldNodes; ++j) {
        sum += static_cast<double>(table.basis[j][k]) * std::pow(static_cast<double>(table.offset[j]), degree);
      }
      const double x = k - kFieldTile / 2;
      EXPECT_NEAR(sum, std::pow(x, degree), 1e-6 * std::pow(kFieldTile / 2, degree)) << degree << " at " << k;
    }
  }
}

}  // namespace
}  // namespace morphkit::warp
