#include "warp/sample/sample.h"
#include "tests/support/threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <ostream>
#include <random>
#include <span>
#include <vector>

namespace morphkit::warp {

// GoogleTest calls it for messages.
void PrintTo(const SampleOptions& options, std::ostream* out) {
  *out << "filter " << static_cast<int>(options.filter) << ", border " << static_cast<int>(options.border);
}

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::array kPointFilters = {Filter::kNearest, Filter::kBilinear, Filter::kBicubic};
constexpr std::array kFilters = {Filter::kNearest, Filter::kBilinear, Filter::kBicubic,
                                 Filter::kArea,    Filter::kMitchell, Filter::kLanczos};
constexpr std::array kBorders = {Border::kTransparent, Border::kClamp, Border::kMirror};

// ---- the specification, in plain double arithmetic ----

/// Interpolation weight of a sample at distance d.
double kernel_weight(Filter filter, double d) {
  d = std::abs(d);
  if (filter == Filter::kBilinear) return std::max(0.0, 1 - d);
  // Keys, a = -1/2, written as in the paper.
  if (d < 1) return 1.5 * d * d * d - 2.5 * d * d + 1;
  if (d < 2) return -0.5 * d * d * d + 2.5 * d * d - 4 * d + 2;
  return 0;
}

/// A pixel of an image that continues without end by the rule of the border.
cv::Vec4d continued(const Image& source, double x, double y, Border border) {
  const auto wrap = [border](double i, int size) {
    if (border == Border::kClamp) return std::clamp(i, 0.0, size - 1.0);
    if (border == Border::kTransparent) return i >= 0 && i < size ? i : -1.0;
    double phase = std::fmod(i, 2.0 * size);
    if (phase < 0) phase += 2.0 * size;
    return phase < size ? phase : 2.0 * size - 1 - phase;
  };
  const double i = wrap(x, source.cols);
  const double j = wrap(y, source.rows);
  if (i < 0 || j < 0) return {};
  return source(static_cast<int>(j), static_cast<int>(i));
}

cv::Vec4d reference(const Image& source, const MapPoint& position, const SampleOptions& options) {
  const double x = position[0];
  const double y = position[1];
  if (!std::isfinite(x) || !std::isfinite(y)) return {};
  if (options.filter == Filter::kNearest) return continued(source, std::floor(x), std::floor(y), options.border);
  const double column = std::floor(x - 0.5);
  const double row = std::floor(y - 0.5);
  cv::Vec4d sum;
  for (int j = -1; j <= 2; ++j) {
    for (int i = -1; i <= 2; ++i) {
      const double weight =
          kernel_weight(options.filter, x - 0.5 - column - i) * kernel_weight(options.filter, y - 0.5 - row - j);
      if (weight != 0) sum += weight * continued(source, column + i, row + j, options.border);
    }
  }
  if (options.filter == Filter::kBicubic) sum[3] = std::clamp(sum[3], 0.0, 1.0);
  return sum;
}

// ---- material ----

Image random_image(cv::Size size, std::mt19937& random) {
  std::uniform_real_distribution<float> color(-0.5F, 4.0F);
  std::uniform_real_distribution<float> alpha(0.0F, 1.0F);
  Image image(size);
  for (Pixel& pixel : image) pixel = {color(random), color(random), color(random), alpha(random)};
  return image;
}

Map identity(cv::Size size) {
  Map map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) map(y, x) = {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
  }
  return map;
}

cv::Size random_size(std::mt19937& random) {
  std::uniform_int_distribution<int> side(1, 67);
  const int width = side(random);
  return {width, side(random)};
}

/// One coordinate: mostly inside and around the image, on centres and edges, sometimes hostile.
float random_coordinate(int size, std::mt19937& random) {
  const float end = static_cast<float>(size);
  constexpr std::array<float, 11> kHostile = {kNan,  kInfinity, -kInfinity, 1e30F, -1e30F, 3.4e38F,
                                              -3e9F, 3e9F,      1e-40F,     -0.0F, -1e-7F};
  switch (std::uniform_int_distribution<int>(0, 9)(random)) {
    case 0:
      return std::floor(std::uniform_real_distribution<float>(-3, end + 3)(random)) + 0.5F;
    case 1:
      return std::floor(std::uniform_real_distribution<float>(-3, end + 3)(random));
    case 2:
      return std::uniform_real_distribution<float>(-20 * end, 20 * end)(random);
    case 3:
      return kHostile[std::uniform_int_distribution<std::size_t>(0, kHostile.size() - 1)(random)];
    case 4:
      return std::nextafter(std::floor(std::uniform_real_distribution<float>(0, end + 1)(random)), -kInfinity);
    default:
      return std::uniform_real_distribution<float>(-3, end + 3)(random);
  }
}

bool same_bytes(const Image& a, const Image& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a[y], b[y], sizeof(Pixel) * static_cast<std::size_t>(a.cols)) != 0) return false;
  }
  return true;
}

class SampleWith : public testing::TestWithParam<SampleOptions> {};

/// Filters that ignore neighbouring positions.
class PointSampleWith : public testing::TestWithParam<SampleOptions> {};

std::vector<SampleOptions> all_options(std::span<const Filter> filters) {
  std::vector<SampleOptions> options;
  for (const Filter filter : filters) {
    for (const Border border : kBorders) options.push_back({filter, border});
  }
  return options;
}

INSTANTIATE_TEST_SUITE_P(All, SampleWith, testing::ValuesIn(all_options(kFilters)));
INSTANTIATE_TEST_SUITE_P(All, PointSampleWith, testing::ValuesIn(all_options(kPointFilters)));

// ---- properties ----

TEST_P(PointSampleWith, AgreesWithTheSpecification) {
  constexpr unsigned kSeed = 1992;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  // Single precision: the position's fraction and about 30 operations on values up to 4, weights summing up to 1.6.
  constexpr double kTolerance = 2e-5;
  for (int round = 0; round < 120; ++round) {
    const Image source = random_image(random_size(random), random);
    Map map(random_size(random));
    for (MapPoint& p : map) p = {random_coordinate(source.cols, random), random_coordinate(source.rows, random)};
    const Image result = sample(source, map, GetParam());
    ASSERT_EQ(result.size(), map.size());
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        const cv::Vec4d expected = reference(source, map(y, x), GetParam());
        for (int c = 0; c < 4; ++c) {
          // In this form NaN fails.
          ASSERT_TRUE(std::abs(result(y, x)[c] - expected[c]) <= kTolerance)
              << result(y, x)[c] << " is not " << expected[c] << " at " << map(y, x) << " of " << source.size();
        }
      }
    }
  }
}

TEST_P(SampleWith, IdentityCopiesEveryBit) {
  constexpr unsigned kSeed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int round = 0; round < 50; ++round) {
    Image source = random_image(random_size(random), random);
    // Values that arithmetic would change: negative zero, denormal, huge, an alpha beyond 1.
    source(0, 0) = {-0.0F, 1e-42F, 3e38F, 1.5F};
    EXPECT_TRUE(same_bytes(sample(source, identity(source.size()), GetParam()), source));
  }
}

TEST_P(SampleWith, WholePixelShiftCopiesEveryBit) {
  constexpr unsigned kSeed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image source = random_image({41, 37}, random);
  const cv::Rect window(13, 5, 20, 30);
  Map map(window.size());
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      map(y, x) = {static_cast<float>(window.x + x) + 0.5F, static_cast<float>(window.y + y) + 0.5F};
    }
  }
  EXPECT_TRUE(same_bytes(sample(source, map, GetParam()), source(window)));
}

TEST_P(SampleWith, PartOfALargerImageIsAnImage) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image large = random_image({50, 40}, random);
  const Image part = large(cv::Rect(7, 9, 21, 17));
  Map map(30, 30);
  for (MapPoint& p : map) p = {random_coordinate(part.cols, random), random_coordinate(part.rows, random)};
  EXPECT_TRUE(same_bytes(sample(part, map, GetParam()), sample(part.clone(), map, GetParam())));
}

TEST_P(PointSampleWith, ConstantStaysConstantInside) {
  constexpr unsigned kSeed = 6;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Pixel color(0.7F, 1.0F, 0.123F, 1.0F);
  const Image source(23, 31, color);
  // Two pixels from the edge, all taps are inside.
  std::uniform_real_distribution<float> x(2, 29);
  std::uniform_real_distribution<float> y(2, 21);
  Map map(40, 40);
  for (MapPoint& p : map) p = {x(random), y(random)};
  for (const Pixel& pixel : sample(source, map, GetParam())) ASSERT_EQ(pixel, color);
}

TEST_P(SampleWith, NonFinitePositionsAreTransparentBlack) {
  const Image source(5, 5, Pixel(1, 2, 3, 1));
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    Map map(1, 3);
    map << MapPoint(bad, 2.5F), MapPoint(2.5F, bad), MapPoint(bad, bad);
    for (const Pixel& pixel : sample(source, map, GetParam())) ASSERT_EQ(pixel, Pixel::all(0));
  }
}

TEST_P(SampleWith, BandEqualsImage) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image source = random_image({19, 23}, random);
  for (int width = 1; width <= 67; ++width) {
    Map map(kSampleBand + 3, width);
    for (MapPoint& p : map) p = {random_coordinate(source.cols, random), random_coordinate(source.rows, random)};
    const Image whole = sample(source, map, GetParam());
    Image band(3, width);
    sample_band(source, map.rowRange(kSampleBand, map.rows), GetParam(), band);
    for (int y = 0; y < band.rows; ++y) {
      ASSERT_EQ(std::memcmp(band[y], whole[kSampleBand + y], static_cast<std::size_t>(width) * sizeof(Pixel)), 0)
          << "width " << width;
    }
  }
}

TEST_P(SampleWith, EmptyInputIsRefused) {
  EXPECT_THROW(sample(Image(), identity({2, 2}), GetParam()), std::invalid_argument);
  EXPECT_THROW(sample(Image(2, 2, Pixel::all(1)), Map(), GetParam()), std::invalid_argument);
}

TEST(Sample, BilinearStaysBetweenItsNeighbours) {
  constexpr unsigned kSeed = 8;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image source = random_image({33, 29}, random);
  Map map(60, 60);
  for (MapPoint& p : map) p = {random_coordinate(source.cols, random), random_coordinate(source.rows, random)};
  for (const Pixel& pixel : sample(source, map, {Filter::kBilinear, Border::kMirror})) {
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(pixel[c] >= -0.5F && pixel[c] <= 4.0F) << pixel;
    ASSERT_TRUE(pixel[3] >= 0 && pixel[3] <= 1) << pixel;
  }
}

TEST(Sample, BicubicReproducesQuadraticsInside) {
  // Third order accuracy (Keys, 1981, section V): parabolas are exact, up to rounding.
  const auto parabola = [](double x, double y) { return 0.01 * x * x - 0.02 * x * y + 0.3 * y - 0.015 * y * y; };
  Image source(30, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) source(y, x) = Pixel::all(static_cast<float>(parabola(x + 0.5, y + 0.5)));
  }
  constexpr unsigned kSeed = 9;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> inside(2, 28);
  Map map(30, 30);
  for (MapPoint& p : map) p = {inside(random), inside(random)};
  const Image result = sample(source, map, {Filter::kBicubic, Border::kClamp});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) ASSERT_NEAR(result(y, x)[0], parabola(map(y, x)[0], map(y, x)[1]), 1e-5);
  }
}

TEST(Sample, BicubicAlphaStaysCoverage) {
  Image source(16, 16, Pixel::all(0));
  source(cv::Rect(8, 0, 8, 16)) = Pixel::all(1);
  Map map(1, 160);
  for (int i = 0; i < 160; ++i) map(0, i) = {static_cast<float>(i) / 10.0F, 8.3F};
  const Image result = sample(source, map, {Filter::kBicubic, Border::kClamp});
  const auto [low, high] = std::ranges::minmax(result, {}, [](const Pixel& p) { return p[0]; });
  EXPECT_LT(low[0], -0.01F) << "colour must undershoot here, or the test proves nothing";
  EXPECT_GT(high[0], 1.01F);
  for (const Pixel& pixel : result) ASSERT_TRUE(pixel[3] >= 0 && pixel[3] <= 1) << pixel;
}

TEST(Sample, TransparentEdgeFadesOverOnePixel) {
  const Image source(8, 8, Pixel(0.5F, 0.5F, 0.5F, 1.0F));
  Map map(1, 4);
  map << MapPoint(0.5F, 4.5F), MapPoint(0.0F, 4.5F), MapPoint(-0.25F, 4.5F), MapPoint(-0.5F, 4.5F);
  const Image result = sample(source, map, {Filter::kBilinear, Border::kTransparent});
  EXPECT_EQ(result(0, 0), Pixel(0.5F, 0.5F, 0.5F, 1.0F));
  EXPECT_EQ(result(0, 1), Pixel(0.25F, 0.25F, 0.25F, 0.5F));
  EXPECT_EQ(result(0, 2), Pixel(0.125F, 0.125F, 0.125F, 0.25F));
  EXPECT_EQ(result(0, 3), Pixel::all(0));
}

TEST(Sample, FarOutside) {
  constexpr unsigned kSeed = 10;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image source = random_image({9, 7}, random);
  Map map(1, 4);
  map << MapPoint(1e30F, 1e30F), MapPoint(-1e30F, 1e30F), MapPoint(1e30F, -1e30F), MapPoint(-3.4e38F, -3.4e38F);
  for (const Filter filter : kFilters) {
    const Image clamped = sample(source, map, {filter, Border::kClamp});
    EXPECT_EQ(clamped(0, 0), source(6, 8));
    EXPECT_EQ(clamped(0, 1), source(6, 0));
    EXPECT_EQ(clamped(0, 2), source(0, 8));
    EXPECT_EQ(clamped(0, 3), source(0, 0));
    for (const Pixel& pixel : sample(source, map, {filter, Border::kTransparent})) ASSERT_EQ(pixel, Pixel::all(0));
  }
}

TEST(Sample, MirrorReflectsAtTheEdge) {
  constexpr unsigned kSeed = 12;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const Image source = random_image({13, 11}, random);
  // Multiples of 1/8 stay exact when reflected; 1/16 off the pixel edges, where kNearest has no mirror image.
  std::uniform_int_distribution<int> eighths(0, 13 * 8 - 1);
  for (const Filter filter : kPointFilters) {
    for (int round = 0; round < 200; ++round) {
      const float x = static_cast<float>(eighths(random)) / 8 + 0.0625F;
      const float y = static_cast<float>(eighths(random) % 88) / 8 + 0.0625F;
      Map map(1, 6);
      map << MapPoint(x, y), MapPoint(-x, y), MapPoint(26 - x, y), MapPoint(x, -y), MapPoint(x, 22 - y),
          MapPoint(x + 26 * 5, y - 22 * 3);
      const Image result = sample(source, map, {filter, Border::kMirror});
      for (int i = 1; i < 6; ++i) {
        for (int c = 0; c < 4; ++c) ASSERT_NEAR(result(0, i)[c], result(0, 0)[c], 1e-5) << "copy " << i;
      }
    }
  }
}

TEST(Sample, GivesTheSameBytesForAnyNumberOfThreads) {
  constexpr unsigned kSeed = 17;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> value(-1, 2);
  std::uniform_real_distribution<float> position(-10, 150);
  Image source(120, 140);
  for (Pixel& pixel : source) pixel = {value(random), value(random), value(random), value(random)};
  Map map(131, 97);
  for (MapPoint& p : map) p = {position(random), position(random)};
  for (const Filter filter : {Filter::kNearest, Filter::kBilinear, Filter::kBicubic}) {
    for (const Border border : {Border::kTransparent, Border::kClamp, Border::kMirror}) {
      test::set_threads(1);
      const Image expected = sample(source, map, {filter, border});
      for (const int count : {2, 5}) {
        test::set_threads(count);
        const Image result = sample(source, map, {filter, border});
        ASSERT_TRUE(result.isContinuous() && expected.isContinuous());
        EXPECT_EQ(std::memcmp(result.data, expected.data, expected.total() * sizeof(Pixel)), 0)
            << count << " threads, filter " << static_cast<int>(filter) << ", border " << static_cast<int>(border);
      }
    }
  }
  test::set_threads(0);
}

}  // namespace
}  // namespace morphkit::warp
