// Colours at points: the kernel against its reference on every instruction set that this machine runs. sample_test.cpp
// tests that the colours are right.

#include "warp/sample/reconstruct.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/warp/image/same_pixels.h"

namespace morphkit::warp::detail {
namespace {

using test::same_pixels;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::array kKernels = {Kernel::kNearest, Kernel::kBilinear, Kernel::kBicubic};
constexpr std::array kBorders = {Border::kTransparent, Border::kClamp, Border::kMirror};
const Pixel kGuard(-7, -7, -7, -7);

using Pixels = std::vector<Pixel>;
using Positions = std::vector<MapPoint>;
using Reconstruct = void (*)(const Image&, std::span<const MapPoint>, Kernel, Border, std::span<Pixel>) noexcept;

class CaseMaker {
 public:
  explicit CaseMaker(unsigned seed) : random_(seed) {}

  float uniform(float low, float high) { return std::uniform_real_distribution(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  bool chance(float probability) { return uniform(0, 1) < probability; }

  /// Colours in [-scale, scale], alpha in [0, scale]; some pixels not finite.
  Image image(cv::Size size, float scale, float hostile) {
    constexpr std::array kHostile = {kNan, kInfinity, -kInfinity, 1e-44F, 3.4e38F, -3.4e38F, -0.0F};
    Image result(size);
    for (Pixel& pixel : result) {
      pixel = {uniform(-scale, scale), uniform(-scale, scale), uniform(-scale, scale), uniform(0, scale)};
      if (chance(hostile)) pixel[integer(0, 3)] = kHostile[static_cast<std::size_t>(integer(0, 6))];
    }
    return result;
  }

  /// Inside, on centres and edges, around, far away, or NaN.
  float coordinate(int size, bool inside) {
    constexpr std::array kHostile = {kNan, kInfinity, -kInfinity, 3.4e38F, -3.4e38F, 3e9F, -1e-40F, -0.0F};
    const float end = static_cast<float>(size);
    switch (inside ? 0 : integer(0, 9)) {
      case 1:
        return static_cast<float>(integer(-3, size + 3)) + 0.5F;
      case 2:
        return static_cast<float>(integer(-3, size + 3));
      case 3:
        return kHostile[static_cast<std::size_t>(integer(0, 7))];
      case 4:
        return uniform(-20 * end, 20 * end);
      case 5:
        return std::nextafter(static_cast<float>(integer(0, size)) + 0.5F, chance(0.5F) ? kInfinity : -kInfinity);
      default:
        return uniform(0, end);
    }
  }

  /// Rows with many, few or no hostile positions.
  Positions positions(std::size_t count, cv::Size size) {
    const float plain = std::array{0.0F, 0.97F, 1.0F}[static_cast<std::size_t>(integer(0, 2))];
    Positions result;
    result.reserve(count);
    while (result.size() < count) {
      const bool inside = chance(plain);
      const float x = coordinate(size.width, inside);
      result.emplace_back(x, coordinate(size.height, inside));
    }
    return result;
  }

 private:
  std::mt19937 random_;
};

Pixels reconstructed(Reconstruct reconstruct, const Image& source, std::span<const MapPoint> positions, Kernel kernel,
                     Border border) {
  Pixels out(positions.size() + 2, kGuard);
  reconstruct(source, positions, kernel, border, std::span(out).subspan(1, positions.size()));
  EXPECT_EQ(out.front(), kGuard);
  EXPECT_EQ(out.back(), kGuard);
  return {out.begin() + 1, out.end() - 1};
}

// The parameter is the instruction set.
class ReconstructRow : public hwy::TestWithParamTarget {};

HWY_TARGET_INSTANTIATE_TEST_SUITE_P(ReconstructRow);

void compare_with_reference(unsigned seeds, float scale, float hostile) {
  for (unsigned seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    const cv::Size size(make.integer(1, 40), make.integer(1, 40));
    // A part of a larger image: its rows are not adjacent.
    const Image whole = make.image({size.width + 5, size.height + 2}, scale, hostile);
    const Image source = whole(cv::Rect({make.integer(0, 5), make.integer(0, 2)}, size));
    const Positions positions = make.positions(seed % 68, size);
    for (const Kernel kernel : kKernels) {
      for (const Border border : kBorders) {
        EXPECT_TRUE(same_pixels(reconstructed(reconstruct_row, source, positions, kernel, border),
                                reconstructed(reference_reconstruct_row, source, positions, kernel, border)))
            << "kernel " << static_cast<int>(kernel) << ", border " << static_cast<int>(border);
      }
    }
  }
}

TEST_P(ReconstructRow, EqualsTheReference) {
  compare_with_reference(1500, 2, 0);
}

TEST_P(ReconstructRow, EqualsTheReferenceOnImagesThatAreNotFinite) {
  compare_with_reference(700, 2, 0.05F);
}

TEST_P(ReconstructRow, EqualsTheReferenceOnDenormalsAndHugeColours) {
  compare_with_reference(300, 1e-38F, 0);
  compare_with_reference(300, 3e38F, 0);
}

TEST_P(ReconstructRow, EqualsTheReferenceOnWideAndOnHighImages) {
  CaseMaker make(11);
  for (const cv::Size size : {cv::Size(70000, 5), cv::Size(5, 70000)}) {
    const Image source = make.image(size, 1, 0);
    const Positions positions = make.positions(2000, size);
    for (const Kernel kernel : kKernels) {
      EXPECT_TRUE(same_pixels(reconstructed(reconstruct_row, source, positions, kernel, Border::kMirror),
                              reconstructed(reference_reconstruct_row, source, positions, kernel, Border::kMirror)));
    }
  }
}

TEST_P(ReconstructRow, APositionIsIndependentOfItsRow) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CaseMaker make(seed);
    const Image source = make.image({31, 33}, 2, 0);
    const Positions positions = make.positions(150, source.size());
    for (const Kernel kernel : kKernels) {
      const Pixels whole = reconstructed(reconstruct_row, source, positions, kernel, Border::kClamp);
      for (std::size_t begin = 0; begin < positions.size();) {
        const std::size_t count = std::min(static_cast<std::size_t>(make.integer(1, 40)), positions.size() - begin);
        const Pixels part =
            reconstructed(reconstruct_row, source, std::span(positions).subspan(begin, count), kernel, Border::kClamp);
        EXPECT_TRUE(same_pixels(part, Pixels(whole.begin() + static_cast<std::ptrdiff_t>(begin),
                                             whole.begin() + static_cast<std::ptrdiff_t>(begin + count))));
        begin += count;
      }
    }
  }
}

TEST_P(ReconstructRow, CentresComeBackBitForBit) {
  CaseMaker make(12);
  const Image source = make.image({37, 9}, 2, 0.5F);
  for (std::size_t count = 0; count <= 67; ++count) {
    Positions positions;
    Pixels expected;
    for (std::size_t i = 0; i < count; ++i) {
      const cv::Point at(make.integer(0, 36), make.integer(0, 8));
      positions.emplace_back(static_cast<float>(at.x) + 0.5F, static_cast<float>(at.y) + 0.5F);
      expected.push_back(source(at));
    }
    for (const Kernel kernel : kKernels) {
      const Pixels out = reconstructed(reconstruct_row, source, positions, kernel, Border::kTransparent);
      EXPECT_TRUE(count == 0 || std::memcmp(out.data(), expected.data(), count * sizeof(Pixel)) == 0);
    }
  }
}

TEST_P(ReconstructRow, AConstantStaysToTheBit) {
  CaseMaker make(13);
  const Pixel constant(0.1F, 1e-30F, -3e20F, 1.0F);
  const Image source(29, 29, constant);
  for (int round = 0; round < 50; ++round) {
    Positions positions;
    for (int i = 0; i < 67; ++i) positions.emplace_back(make.uniform(-9, 40), make.uniform(-9, 40));
    for (const Kernel kernel : kKernels) {
      for (const Pixel& pixel : reconstructed(reconstruct_row, source, positions, kernel, Border::kMirror)) {
        ASSERT_EQ(pixel, constant);
      }
    }
  }
}

}  // namespace
}  // namespace morphkit::warp::detail
