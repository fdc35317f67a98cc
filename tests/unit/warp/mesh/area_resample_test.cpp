// Area resampling of a line: the properties of the reference, and the kernel against it on every instruction set that
// this machine runs.

#include "warp/mesh/area_resample.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace morphkit::warp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Pixel kGuard(-7, -7, -7, -7);

using Pixels = std::vector<Pixel>;
using Edges = std::vector<double>;
using Resample = void (*)(std::span<const Pixel>, const LineEdges&, std::span<Pixel>) noexcept;

class CaseMaker {
 public:
  explicit CaseMaker(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  std::size_t integer(std::size_t low, std::size_t high) { return std::uniform_int_distribution(low, high)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  /// Colours in [-scale, scale], alpha in [0, 1].
  Pixels pixels(std::size_t count, double scale = 1) {
    Pixels result(count);
    for (Pixel& pixel : result) {
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(uniform(-scale, scale));
      pixel[3] = static_cast<float>(uniform(0, 1));
    }
    return result;
  }

  /// Edges within a source of `pixels`: magnified, minified and empty stretches, runs of whole and nearly whole
  /// numbers.
  Edges edges(std::size_t count, std::size_t pixels) {
    const double end = static_cast<double>(pixels);
    Edges result;
    double at = chance(0.5) ? 0 : uniform(0, end);
    int kind = 0;
    while (result.size() < count) {
      if (result.empty() || chance(0.1)) kind = static_cast<int>(integer(0, 5));
      result.push_back(at);
      const double steps[] = {0, 1e-6, uniform(0, 0.1), uniform(0.5, 1.5), 1, uniform(1, 9)};
      if (kind == 4) at = std::floor(at);
      at = std::min(std::max(at, result.back()) + steps[kind], end);
      if (kind == 4) at = std::max(std::round(at), result.back());
      if (kind == 3 && chance(0.1)) at = std::min(std::ceil(at) + uniform(-1e-9, 1e-9), end);
      at = std::clamp(at, result.back(), end);
    }
    return result;
  }

 private:
  std::mt19937 random_;
};

Pixels resampled(Resample resample, const Pixels& source, const Edges& edges, double begin, double end) {
  Pixels out(edges.size() + 1, kGuard);
  resample(source, {edges, begin, end}, std::span(out).subspan(1, edges.size() - 1));
  EXPECT_EQ(out.front(), kGuard);
  EXPECT_EQ(out.back(), kGuard);
  return {out.begin() + 1, out.end() - 1};
}

Pixels resampled(Resample resample, const Pixels& source, const Edges& edges) {
  return resampled(resample, source, edges, 0, static_cast<double>(edges.size()) - 1);
}

double largest_magnitude(const Pixels& pixels) {
  double largest = 0;
  for (const Pixel& pixel : pixels) {
    for (const float value : pixel.val) largest = std::max(largest, std::abs(static_cast<double>(value)));
  }
  return largest;
}

/// Infinite if anything is not finite.
double difference(const Pixel& a, const Pixel& b) {
  double worst = 0;
  for (int c = 0; c < 4; ++c) {
    const double distance = std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c]));
    worst = std::isfinite(distance) ? std::max(worst, distance) : HUGE_VAL;
  }
  return worst;
}

double worst_difference(const Pixels& a, const Pixels& b) {
  double worst = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) worst = std::max(worst, difference(a[k], b[k]));
  return worst;
}

bool same_bits(const Pixels& a, const Pixels& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Pixel)) == 0;
}

bool is_finite(const Pixel& pixel) {
  return std::all_of(pixel.val, pixel.val + 4, [](float value) { return std::isfinite(value); });
}

// ---- The reference.

TEST(AreaResampleReference, ShiftByHalfAPixelIsCubicInterpolation) {
  CaseMaker make(1);
  const Pixels source = make.pixels(8);
  Edges edges;
  for (int k = 0; k < 8; ++k) edges.push_back(k + 0.5);
  const Pixels out = resampled(reference_resample_line, source, edges);
  for (std::size_t k = 1; k < 6; ++k) {
    const Pixel expected = (9 * (source[k] + source[k + 1]) - source[k - 1] - source[k + 2]) / 16;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(out[k][c], expected[c], 1e-6) << k;
  }
}

TEST(AreaResampleReference, KeepsTheSum) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    const Pixels source = make.pixels(make.integer(1, 40));
    Edges edges{0, static_cast<double>(source.size())};
    for (int i = 0; i < 30; ++i) edges.push_back(make.uniform(0, edges[1]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(), [](double a, double b) { return b - a < 1e-3; }), edges.end());
    edges.back() = static_cast<double>(source.size());
    const Pixels out = resampled(reference_resample_line, source, edges);
    for (int c = 0; c < 3; ++c) {
      double before = 0;
      double after = 0;
      for (const Pixel& pixel : source) before += static_cast<double>(pixel[c]);
      for (std::size_t k = 0; k < out.size(); ++k) after += static_cast<double>(out[k][c]) * (edges[k + 1] - edges[k]);
      EXPECT_NEAR(before, after, 1e-5);
    }
  }
}

TEST(AreaResampleReference, IsExactOnARamp) {
  CaseMaker make(3);
  Pixels source(40);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const float at = (static_cast<float>(i) + 0.5F) / 64;
    source[i] = {at, 2 * at, 1 - at, at};
  }
  Edges edges{1};
  while (edges.back() < 36) edges.push_back(edges.back() + make.uniform(0.002, 2.9));
  const Pixels out = resampled(reference_resample_line, source, edges);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double at = (edges[k] + edges[k + 1]) / 128;
    EXPECT_LE(difference(out[k], Pixel(cv::Vec4d(at, 2 * at, 1 - at, at))), 1e-6) << k;
  }
}

TEST(AreaResampleReference, IsTheSameFromBothEnds) {
  CaseMaker make(4);
  Pixels source = make.pixels(30);
  Edges edges = make.edges(60, source.size());
  Pixels out = resampled(reference_resample_line, source, edges);
  std::reverse(source.begin(), source.end());
  std::reverse(edges.begin(), edges.end());
  for (double& edge : edges) edge = static_cast<double>(source.size()) - edge;
  std::reverse(out.begin(), out.end());
  EXPECT_LE(worst_difference(resampled(reference_resample_line, source, edges), out), 1e-6);
}

TEST(AreaResampleReference, AShortIntervalShowsThePointInIt) {
  const Pixels source = CaseMaker(5).pixels(9);
  const Pixels out = resampled(reference_resample_line, source, {4.5, 4.5, 4.5 + 1e-5});
  const Pixels around = resampled(reference_resample_line, source, {4.5 - 5e-4, 4.5 + 5e-4});
  for (const Pixel& pixel : out) EXPECT_LE(difference(pixel, around[0]), 1e-4);
  EXPECT_TRUE(is_finite(resampled(reference_resample_line, source, {0, 0})[0]));
  EXPECT_TRUE(is_finite(resampled(reference_resample_line, source, {9, 9})[0]));
}

// ---- Both; the parameter is the instruction set.

class AreaResample : public hwy::TestWithParamTarget {};

HWY_TARGET_INSTANTIATE_TEST_SUITE_P(AreaResample);

TEST_P(AreaResample, AgreesWithTheReference) {
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    const Pixels source = make.pixels(make.integer(1, 90), std::pow(10, make.uniform(-30, 30)));
    const Edges edges = make.edges(1 + seed % 68, source.size());
    const double width = static_cast<double>(edges.size());
    const double begin = make.chance(0.5) ? 0 : make.uniform(-1, width);
    const double end = make.chance(0.5) ? width : begin + make.uniform(-0.5, width);
    const Pixels fast = resampled(resample_line, source, edges, begin, end);
    const Pixels reference = resampled(reference_resample_line, source, edges, begin, end);
    EXPECT_LE(worst_difference(fast, reference), kResampleTolerance * largest_magnitude(source));
  }
}

TEST_P(AreaResample, LongLinesAgreeWithTheReference) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    Pixels source = make.pixels(60000 + seed);
    // Sums that grow, the second with the same rounding at every step.
    for (Pixel& pixel : source) {
      pixel[0] = 0.75F + pixel[0] / 4;
      pixel[1] = 0.9F;
    }
    source[0][1] = 0;
    const double end = static_cast<double>(source.size());
    for (const Edges& edges :
         {Edges{0, end}, Edges{0.3, 5000.1, 5001.3, 40000.7, end}, make.edges(9000, source.size())}) {
      EXPECT_LE(
          worst_difference(resampled(resample_line, source, edges), resampled(reference_resample_line, source, edges)),
          kResampleTolerance);
    }
  }
}

TEST_P(AreaResample, DenormalsAgreeWithTheReference) {
  CaseMaker make(6);
  const Pixels source = make.pixels(50, 1e-40);
  const Edges edges = make.edges(68, source.size());
  const Pixels fast = resampled(resample_line, source, edges);
  const Pixels reference = resampled(reference_resample_line, source, edges);
  for (std::size_t k = 0; k < fast.size(); ++k) {
    // Denormals have an absolute precision.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fast[k][c], reference[k][c], 20 * 0x1p-149) << k;
  }
}

TEST_P(AreaResample, WholePixelsComeBackBitForBit) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    Pixels source = make.pixels(make.integer(1, 70));
    const float odd[] = {-0.0F, kNan, kInfinity, -kInfinity, 1e-44F, 3e38F, 1.5F, -0.5F};
    for (Pixel& pixel : source) pixel[static_cast<int>(make.integer(0, 3))] = odd[make.integer(0, 7)];
    const std::size_t first = make.integer(0, source.size());
    Edges edges;
    for (std::size_t i = first; i <= source.size(); ++i) edges.push_back(static_cast<double>(i));
    const Pixels expected(source.begin() + static_cast<std::ptrdiff_t>(first), source.end());
    EXPECT_TRUE(same_bits(resampled(resample_line, source, edges), expected));
    EXPECT_TRUE(same_bits(resampled(reference_resample_line, source, edges), expected));
    // Beside pixels that are not whole, too.
    edges.insert(edges.begin(), 3, edges.front() / 3);
    const Pixels mixed = resampled(resample_line, source, edges);
    EXPECT_TRUE(same_bits(Pixels(mixed.begin() + 3, mixed.end()), expected));
  }
}

TEST_P(AreaResample, AConstantStaysToTheBit) {
  const Pixel constant(0.1F, 1e-30F, -3e20F, 1.0F);
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    const Pixels source(make.integer(1, 300), constant);
    const Edges edges = make.edges(68, source.size());
    EXPECT_TRUE(same_bits(resampled(resample_line, source, edges), Pixels(67, constant)));
    EXPECT_TRUE(same_bits(resampled(reference_resample_line, source, edges), Pixels(67, constant)));
  }
}

TEST_P(AreaResample, AlphaStaysInTheUnitInterval) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    Pixels source = make.pixels(40);
    for (Pixel& pixel : source) pixel[3] = make.chance(0.5) ? 1.0F : 0.0F;
    for (const Pixel& pixel : resampled(resample_line, source, make.edges(68, source.size()))) {
      EXPECT_GE(pixel[3], 0);
      EXPECT_LE(pixel[3], 1);
    }
  }
}

TEST_P(AreaResample, CoverageFadesTheEnds) {
  const Pixels source(10, Pixel(0.5F, 1, 2, 1));
  const Edges edges{0, 0, 2.2, 4.7, 9.9, 10, 10};
  for (const Resample resample : {Resample(resample_line), Resample(reference_resample_line)}) {
    const auto alphas = [&](double begin, double end) {
      std::vector<float> result;
      for (const Pixel& pixel : resampled(resample, source, edges, begin, end)) {
        EXPECT_EQ(pixel[2], 2 * pixel[3]);
        result.push_back(pixel[3]);
      }
      return result;
    };
    using Alphas = std::vector<float>;
    EXPECT_EQ(alphas(0.25, 4.5), (Alphas{0.75F, 1, 1, 1, 0.5F, 0}));
    EXPECT_EQ(alphas(1, 5), (Alphas{0, 1, 1, 1, 1, 0}));
    EXPECT_EQ(alphas(2.25, 2.75), (Alphas{0, 0, 0.5F, 0, 0, 0}));
    EXPECT_EQ(alphas(-4, 99), (Alphas{1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(alphas(3, 3), (Alphas{0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(alphas(5, 2), (Alphas{0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(alphas(7, 9), (Alphas{0, 0, 0, 0, 0, 0}));
  }
}

TEST_P(AreaResample, NonFinitePixelsSpoilOnlyTheirNeighbourhood) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    Pixels source = make.pixels(make.integer(1, 60));
    const double place = static_cast<double>(make.integer(0, source.size() - 1));
    const float bad[] = {kNan, kInfinity, -kInfinity};
    source[static_cast<std::size_t>(place)][static_cast<int>(make.integer(0, 3))] = bad[make.integer(0, 2)];
    const Edges edges = make.edges(68, source.size());
    const Pixels fast = resampled(resample_line, source, edges);
    const Pixels reference = resampled(reference_resample_line, source, edges);
    for (std::size_t k = 0; k < fast.size(); ++k) {
      const bool whole = edges[k] == std::floor(edges[k]) && edges[k + 1] == edges[k] + 1;
      EXPECT_TRUE(whole || is_finite(fast[k])) << k;
      EXPECT_TRUE(whole || is_finite(reference[k])) << k;
      if (edges[k] > place + 3 || edges[k + 1] < place - 3) {
        EXPECT_LE(difference(fast[k], reference[k]), kResampleTolerance) << k;
      }
    }
  }
}

TEST(AreaResampleReference, AnEmptyIntervalDrawsNothing) {
  const Pixels source(3, Pixel(1, 1, 1, 1));
  EXPECT_TRUE(resampled(resample_line, source, {1.5}).empty());
  EXPECT_TRUE(resampled(reference_resample_line, source, {1.5}).empty());
}

}  // namespace
}  // namespace morphkit::warp
