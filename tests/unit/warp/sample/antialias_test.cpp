// Sampling over footprints: the kernel against the reference on every instruction set that this machine runs, and
// properties for any map.

#include "warp/sample/antialias.h"
#include "tests/support/threads.h"

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "warp/sample/sample.h"

namespace morphkit::warp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::array kFilters = {Filter::kArea, Filter::kMitchell, Filter::kLanczos};
constexpr std::array kBorders = {Border::kTransparent, Border::kClamp, Border::kMirror};

class CaseMaker {
 public:
  explicit CaseMaker(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  /// Colours in [-1, 1], alpha in [0, 1].
  Image image(cv::Size size) {
    Image result(size);
    for (Pixel& pixel : result) {
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(uniform(-1, 1));
      pixel[3] = static_cast<float>(uniform(0, 1));
    }
    return result;
  }

  /// A slightly curved affine map around a point of the source: up to `most` source pixels per output pixel in one
  /// direction, and anything down to a fold in the other.
  Map map(cv::Size size, cv::Size source, double most, double most_bend = 0.01) {
    const double u = uniform(0, 7);
    const double v = uniform(0, 7);
    const double larger = uniform(0, most);
    const double smaller = chance(0.3) ? larger : uniform(-0.5, 1) * larger;
    const auto rotation = [](double angle) {
      return cv::Matx22d(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
    };
    const cv::Matx22d linear = rotation(u) * cv::Matx22d::diag({larger, smaller}) * rotation(v);
    const cv::Vec2d middle(uniform(-5, source.width + 5), uniform(-5, source.height + 5));
    const cv::Vec2d bend(uniform(-most_bend, most_bend), uniform(-most_bend, most_bend));
    Map result(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const cv::Vec2d at(x - size.width / 2.0, y - size.height / 2.0);
        result(y, x) = cv::Vec2f(middle + linear * at + bend * at.dot(at));
      }
    }
    return result;
  }

  cv::Size size(int most) {
    const int width = integer(1, most);
    return {width, integer(1, most)};
  }

  float hostile() {
    constexpr std::array<float, 9> kValues = {kNan,    kInfinity, -kInfinity, 1e30F, -1e30F,
                                              3.4e38F, -3e9F,     1e-40F,     -0.0F};
    return kValues[static_cast<std::size_t>(integer(0, 8))];
  }

 private:
  std::mt19937 random_;
};

bool same_bytes(const Image& a, const Image& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a[y], b[y], sizeof(Pixel) * static_cast<std::size_t>(a.cols)) != 0) return false;
  }
  return true;
}

/// Infinite if any value is NaN.
double worst_difference(const Image& a, const Image& b) {
  double worst = 0;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      for (int c = 0; c < 4; ++c) {
        const double difference = std::abs(static_cast<double>(a(y, x)[c]) - static_cast<double>(b(y, x)[c]));
        worst = std::isnan(difference) ? HUGE_VAL : std::max(worst, difference);
      }
    }
  }
  return worst;
}

class Antialias : public hwy::TestWithParamTarget {
 protected:
  void expect_agreement(CaseMaker& make, const Image& source, const Map& map) {
    for (const Filter filter : kFilters) {
      const Border border = kBorders[static_cast<std::size_t>(make.integer(0, 2))];
      Image out(map.size());
      Image reference(map.size());
      detail::antialias_band(source, map, filter, border, out);
      detail::reference_antialias_band(source, map, filter, border, reference);
      ASSERT_LE(worst_difference(out, reference), detail::kAntialiasTolerance)
          << "filter " << static_cast<int>(filter) << ", border " << static_cast<int>(border) << ", source "
          << source.size() << ", map " << map.size();
    }
  }
};
HWY_TARGET_INSTANTIATE_TEST_SUITE_P(Antialias);

TEST_P(Antialias, AgreesWithTheReference) {
  constexpr unsigned kSeed = 1988;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  for (int round = 0; round < 60; ++round) {
    const Image source = make.image(make.size(67));
    expect_agreement(make, source, make.map({make.integer(1, 140), make.integer(1, 4)}, source.size(), 4));
  }
  for (int round = 0; round < 6; ++round) {
    const Image source = make.image(make.size(140));
    expect_agreement(make, source, make.map({make.integer(1, 20), make.integer(1, 4)}, source.size(), 40));
  }
}

TEST_P(Antialias, AgreesWithTheReferenceOnEveryWidth) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Image source = make.image({31, 27});
  for (int width = 1; width <= 67; ++width) expect_agreement(make, source, make.map({width, 2}, source.size(), 3));
}

TEST_P(Antialias, AgreesWithTheReferenceOnHostilePositions) {
  constexpr unsigned kSeed = 6;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  for (int round = 0; round < 20; ++round) {
    const Image source = make.image(make.size(20));
    Map map = make.map({make.integer(1, 70), make.integer(1, 5)}, source.size(), 3);
    for (MapPoint& position : map) {
      if (make.chance(0.05)) position[make.integer(0, 1)] = make.hostile();
    }
    expect_agreement(make, source, map);
  }
}

TEST_P(Antialias, ConstantsStayConstantToTheBit) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Pixel color(0.7F, 1.0F, 0.123F, 1.0F);
  const Image source(33, 29, color);
  for (int round = 0; round < 40; ++round) {
    const Map map = make.map({70, 3}, source.size(), 5);
    for (const Filter filter : kFilters) {
      Image out(map.size());
      detail::antialias_band(source, map, filter, make.chance(0.5) ? Border::kClamp : Border::kMirror, out);
      for (const Pixel& pixel : out) ASSERT_EQ(pixel, color);
    }
  }
}

TEST_P(Antialias, WhereNothingShrinksItIsBicubicToTheBit) {
  constexpr unsigned kSeed = 8;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Image source = make.image({60, 50});
  for (int round = 0; round < 40; ++round) {
    Map map = make.map({100, 16}, source.size(), 1.05, 1e-4);
    for (MapPoint& position : map) {
      if (make.chance(0.01)) position = MapPoint::all(kNan);
    }
    for (const Border border : kBorders) {
      const Image bicubic = sample(source, map, {Filter::kBicubic, border});
      for (const Filter filter : kFilters) EXPECT_TRUE(same_bytes(sample(source, map, {filter, border}), bicubic));
    }
  }
}

TEST_P(Antialias, AlphaStaysCoverage) {
  Image source(40, 40, Pixel::all(0));
  source(cv::Rect(13, 0, 14, 40)) = Pixel::all(1);
  Map map(16, 25);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      map(y, x) = {1.6F * static_cast<float>(x), 1.6F * static_cast<float>(y) + 0.1F * static_cast<float>(x)};
    }
  }
  const Image out = sample(source, map, {Filter::kLanczos, Border::kClamp});
  float least = 0;
  for (const Pixel& pixel : out) {
    ASSERT_TRUE(pixel[3] >= 0 && pixel[3] <= 1) << pixel;
    least = std::min(least, pixel[0]);
  }
  EXPECT_LT(least, -0.01F) << "colour must undershoot here, or the test proves nothing";
}

TEST(AntialiasMaps, ANonFinitePositionDoesNotSpoilItsNeighbours) {
  constexpr unsigned kSeed = 10;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Image source = make.image({200, 200});
  Map map(16, 80);
  for (int y = 0; y < map.rows; ++y) {
    // Eighths, so that differences are exact.
    for (int x = 0; x < map.cols; ++x) {
      map(y, x) = {2.25F * static_cast<float>(x) + 0.5F * static_cast<float>(y) + 3,
                   2.125F * static_cast<float>(y) + 40};
    }
  }
  Map torn = map.clone();
  // Every other pixel keeps a neighbour in either direction.
  for (int x = 2; x < map.cols - 2; x += 5) torn(2 + x % (map.rows - 4), x) = {kNan, 2};
  for (const Filter filter : kFilters) {
    const Image whole = sample(source, map, {filter, Border::kTransparent});
    const Image holes = sample(source, torn, {filter, Border::kTransparent});
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        ASSERT_EQ(holes(y, x), torn(y, x)[0] == map(y, x)[0] ? whole(y, x) : Pixel::all(0)) << x << " " << y;
      }
    }
  }
}

/// A single row as a band would have no differences across rows.
TEST(AntialiasMaps, TheLastRowIsLikeTheOthersForAnyHeight) {
  CaseMaker make(3);
  const Image source = make.image({64, 256});
  Map map(kSampleBand + 9, 40);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) map(y, x) = {10 + static_cast<float>(x), 20 + 3.5F * static_cast<float>(y)};
  }
  const Image all = sample(source, map, {});
  for (int height = 2; height < map.rows; ++height) {
    const Image some = sample(source, map.rowRange(0, height), {});
    for (int x = 0; x < map.cols; ++x)
      EXPECT_LE(cv::norm(cv::Vec4f(some(height - 1, x)) - cv::Vec4f(all(height - 1, x))), 1e-5) << height << ' ' << x;
  }
}

TEST(AntialiasMaps, GivesTheSameBytesForAnyNumberOfThreads) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Image source = make.image({150, 120});
  const Map map = make.map({90, 130}, source.size(), 2);
  for (const Filter filter : kFilters) {
    test::set_threads(1);
    const Image one = sample(source, map, {filter, Border::kMirror});
    for (const int threads : {2, 5}) {
      test::set_threads(threads);
      EXPECT_TRUE(same_bytes(sample(source, map, {filter, Border::kMirror}), one)) << threads << " threads";
    }
  }
  test::set_threads(0);
}

TEST(AntialiasMaps, ColoursChangeSmoothlyAsAMapZoomsAndPans) {
  constexpr unsigned kSeed = 12;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CaseMaker make(kSeed);
  const Image source = make.image({400, 100});
  const cv::Size size(60, 16);
  const auto zoomed = [&](double scale, double angle) {
    Map map(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const cv::Point2d at = scale * cv::Point2d(x - size.width / 2.0, y - size.height / 2.0);
        map(y, x) = {static_cast<float>(200.3 + at.x * std::cos(angle) - at.y * std::sin(angle)),
                     static_cast<float>(50.1 + at.x * std::sin(angle) + at.y * std::cos(angle))};
      }
    }
    return map;
  };
  // A step moves the farthest pixel by 0.24 px, mostly by rotation. Noise changes by up to 2 from one pixel to the
  // next, and the slope of the sharpest kernel is slightly above 1 per pixel.
  constexpr double kStep = 0.001;
  for (const Filter filter : kFilters) {
    Image before;
    for (double scale = 0.9; scale < 2.5; scale += kStep) {
      const Image now = sample(source, zoomed(scale, 3 * scale), {filter, Border::kTransparent});
      if (!before.empty()) {
        ASSERT_LE(worst_difference(now, before), 0.6) << "at scale " << scale;
      }
      before = now;
    }
  }
}

}  // namespace
}  // namespace morphkit::warp
