// The error from interpolating far lines, against the bound that the plan of a tile uses.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "warp/field/line_field_plan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace morphkit::warp::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kCases = 20000;

/// A line relative to the middle pixel of a tile, and a channel that is affine over the tile.
struct Case {
  double a = 0, b = 0;
  double across = 0, before = 0, after = 0, along_x = 1, along_y = 0;
  double at = 1, slope_x = 0, slope_y = 0;

  double distance(double x, double y) const {
    const double moved = x * along_x + y * along_y;
    const double v = across + y * along_x - x * along_y;
    return std::hypot(v, std::max({before - moved, after + moved, 0.0}));
  }
  double weight(double distance_px) const { return std::pow(a + distance_px, -b); }
  double weighted(double x, double y) const { return weight(distance(x, y)) * (at + slope_x * x + slope_y * y); }
  double turn() const { return kHalf * (std::abs(slope_x) + std::abs(slope_y)); }
};

/// The largest error over a tile, relative to the largest weight.
double measured(const Case& line) {
  const NodeTable& nodes = node_table();
  double at_nodes[kNodes][kNodes];
  for (size_t j = 0; j < kNodes; ++j) {
    for (size_t i = 0; i < kNodes; ++i)
      at_nodes[j][i] = line.weighted(static_cast<double>(nodes.offset[i]), static_cast<double>(nodes.offset[j]));
  }
  double worst = 0;
  for (int y = 0; y < kFieldTile; ++y) {
    for (int x = 0; x < kFieldTile; ++x) {
      double sum = 0;
      for (size_t j = 0; j < kNodes; ++j) {
        for (size_t i = 0; i < kNodes; ++i)
          sum += static_cast<double>(nodes.basis[j][y]) * static_cast<double>(nodes.basis[i][x]) * at_nodes[j][i];
      }
      worst = std::max(worst, std::abs(sum - line.weighted(x - kHalf, y - kHalf)));
    }
  }
  return worst / line.weight(std::max(line.distance(0, 0) - kRadiusPx, 0.0));
}

double bound(const Case& line) {
  const hn::CappedTag<float, 1> d;
  const auto set = [d](double value) { return hn::Set(d, static_cast<float>(value)); };
  double smooth = 1;
  for (int j = 0; j < kFieldNodes; ++j) smooth *= (line.b + j) / (j + 1);
  return static_cast<double>(hn::GetLane(interpolation_error(d, set(line.distance(0, 0)), set(line.a), set(line.b),
                                                             set(smooth), set(line.before), set(line.after),
                                                             set(std::abs(line.at) + line.turn()), set(line.turn()))));
}

class LineFieldBound : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  double pick(std::initializer_list<double> values) {
    return *(values.begin() + std::uniform_int_distribution<int>(0, static_cast<int>(values.size()) - 1)(random_));
  }

  /// A random line, at a distance between twice the width of a tile and the size of a picture; many end beside the
  /// tile.
  Case line() {
    Case line;
    line.a = pick({0, 0.3, 1, 10, 100});
    line.b = pick({0.5, 1, 1.5, 2, 4, 8, uniform(0, 8)});
    const double angle = uniform(0, 6.3);
    line.along_x = std::cos(angle);
    line.along_y = std::sin(angle);
    const double length = pick({0, uniform(0, 30), uniform(0, 400), 3000});
    line.before = pick({uniform(-kRadiusPx, kRadiusPx), uniform(-400, 400), -length / 2});
    line.after = -line.before - length;
    line.across = std::exp(uniform(std::log(20), std::log(2000))) * pick({-1, 1});
    return line;
  }

  std::mt19937 random_{11};
};

TEST_F(LineFieldBound, HoldsForWeights) {
  double nearest = 0;
  for (int i = 0; i < kCases; ++i) {
    const Case line = this->line();
    const double worst = measured(line), most = bound(line);
    // Smaller errors are rounding of the polynomials, which has its own bound.
    if (worst < 1e-6) continue;
    EXPECT_LE(worst, most) << "case " << i << " distance " << line.distance(0, 0) << " a " << line.a << " b " << line.b;
    if (most < 1) nearest = std::max(nearest, worst / most);
  }
  EXPECT_GT(nearest, 0.5) << "a bound far above all errors costs time";
}

TEST_F(LineFieldBound, HoldsForWeightedChannels) {
  double nearest = 0;
  for (int i = 0; i < kCases; ++i) {
    Case line = this->line();
    line.at = pick({0, 1, uniform(-1, 1)});
    line.slope_x = uniform(-1, 1) / kHalf;
    line.slope_y = uniform(-1, 1) / kHalf;
    const double worst = measured(line), most = bound(line);
    if (worst < 1e-6) continue;
    EXPECT_LE(worst, most) << "case " << i << " distance " << line.distance(0, 0) << " a " << line.a << " b " << line.b;
    if (most < 1) nearest = std::max(nearest, worst / most);
  }
  EXPECT_GT(nearest, 0.5) << "a bound far above all errors costs time";
}

}  // namespace HWY_NAMESPACE
}  // namespace morphkit::warp::detail
HWY_AFTER_NAMESPACE();
