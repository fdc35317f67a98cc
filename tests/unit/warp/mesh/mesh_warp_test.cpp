#include "warp/mesh/mesh_warp.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/threads.h"
#include "warp/analysis.h"
#include "warp/mesh/mesh_curves.h"

namespace morphkit::warp {
namespace {

constexpr MeshSpline kSplines[] = {MeshSpline::kMonotone, MeshSpline::kCatmullRom, MeshSpline::kLinear};
constexpr PassOrder kOrders[] = {PassOrder::kRowsFirst, PassOrder::kColumnsFirst};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0; }
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

 private:
  std::mt19937 engine_;
};

Image random_image(cv::Size size, unsigned seed) {
  Random random(seed);
  Image image(size);
  for (Pixel& pixel : image) {
    const auto alpha = static_cast<float>(random.between(0, 1));
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(random.between(-0.1, 1.2)) * alpha;
    pixel[3] = alpha;
  }
  return image;
}

cv::Rect2d outline_of(cv::Size size) {
  return {{0, 0}, cv::Size2d(size)};
}

/// Inner vertices moved by less than half a cell: always in order.
Mesh jittered(int columns, int rows, const cv::Rect2d& outline, Random& random, double amount = 0.45) {
  Mesh mesh = uniform_mesh(columns, rows, outline);
  for (int row = 1; row < rows - 1; ++row)
    for (int column = 1; column < columns - 1; ++column)
      mesh.at(column, row) += cv::Point2d(random.between(-amount, amount) * outline.width / (columns - 1),
                                          random.between(-amount, amount) * outline.height / (rows - 1));
  return mesh;
}

/// A smooth bend of the inside: a few waves in both directions that vanish at the border. Strong ones fold.
Mesh waved(int columns, int rows, const cv::Rect2d& outline, Random& random, double strength) {
  const double fx = random.whole(1, 3), fy = random.whole(1, 3), phase = random.between(0, 6.28);
  const double slant = random.between(-1, 1);
  Mesh mesh = uniform_mesh(columns, rows, outline);
  for (cv::Point2d& vertex : mesh.vertices) {
    const double u = (vertex.x - outline.x) / outline.width, v = (vertex.y - outline.y) / outline.height;
    const double inside = 16 * u * (1 - u) * v * (1 - v);
    vertex.x += strength * outline.width * inside * (std::sin(6.28 * fy * v + phase) / 6 + slant * (v - 0.5));
    vertex.y += strength * outline.height * inside * (std::cos(6.28 * fx * u + phase) / 6 + slant * (u - 0.5));
  }
  snap_to_outline(mesh, outline);
  return mesh;
}

::testing::AssertionResult same_bits(const Image& a, const Image& b) {
  if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " against " << b.size();
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x)
      if (std::memcmp(&a(y, x), &b(y, x), sizeof(Pixel)) != 0)
        return ::testing::AssertionFailure() << "at (" << x << ", " << y << "): " << a(y, x) << " against " << b(y, x);
  return ::testing::AssertionSuccess();
}

double largest_difference(const Image& a, const Image& b, const cv::Rect& part) {
  double largest = 0;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x)
      for (int c = 0; c < 4; ++c) largest = std::max(largest, static_cast<double>(std::abs(a(y, x)[c] - b(y, x)[c])));
  return largest;
}

TEST(MeshWarp, EqualMeshesReturnTheImageBitForBit) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const cv::Size size(random.whole(1, 90), random.whole(1, 90));
    const Mesh mesh = jittered(random.whole(2, 40), random.whole(2, 40), outline_of(size), random);
    const Image image = random_image(size, seed);
    for (const MeshSpline spline : kSplines)
      for (const PassOrder order : kOrders)
        for (const Border border : {Border::kTransparent, Border::kClamp})
          EXPECT_TRUE(same_bits(MeshWarp(mesh, mesh, {spline, order}).apply(image, size, border), image));
  }
}

TEST(MeshWarp, MovesByWholePixelsExactly) {
  const cv::Size size(40, 30);
  const Image image = random_image(size, 1);
  const Mesh from = uniform_mesh(5, 4, outline_of(size)), to = uniform_mesh(5, 4, {7, 3, 40, 30});
  const Image moved = MeshWarp(from, to).apply(image, {60, 50});
  EXPECT_TRUE(same_bits(moved(cv::Rect(7, 3, 40, 30)).clone(), image));
  EXPECT_EQ(moved(2, 20), Pixel(0, 0, 0, 0));
  EXPECT_EQ(moved(20, 6), Pixel(0, 0, 0, 0));
  EXPECT_EQ(moved(33, 20), Pixel(0, 0, 0, 0));
}

TEST(MeshWarp, HalvesByAveragingFourPixels) {
  const cv::Size size(48, 36);
  const Image image = random_image(size, 2);
  const Mesh from = uniform_mesh(7, 5, outline_of(size)), to = uniform_mesh(7, 5, {0, 0, 24, 18});
  const Image half = MeshWarp(from, to).apply(image, {24, 18});
  for (int y = 0; y < 18; ++y)
    for (int x = 0; x < 24; ++x)
      for (int c = 0; c < 4; ++c) {
        const float mean = (image(2 * y, 2 * x)[c] + image(2 * y, 2 * x + 1)[c] + image(2 * y + 1, 2 * x)[c] +
                            image(2 * y + 1, 2 * x + 1)[c]) /
                           4;
        ASSERT_NEAR(half(y, x)[c], mean, 2e-6);
      }
}

TEST(MeshWarp, ShiftsAndGrowsASmoothPictureAsTheFormulaSays) {
  const cv::Size size(64, 64);
  Image image(size);
  const auto value = [](double x, double y) { return 0.5 + 0.4 * std::sin(x / 9) * std::cos(y / 7); };
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      image(y, x) = Pixel(1, 1, 1, 0) * static_cast<float>(value(x + 0.5, y + 0.5)) + Pixel(0, 0, 0, 1);
  const cv::Rect2d to(3.3, -2.6, 128, 96);
  const Image bent =
      MeshWarp(uniform_mesh(6, 6, outline_of(size)), uniform_mesh(6, 6, to)).apply(image, {110, 80}, Border::kClamp);
  for (int y = 12; y < 70; ++y)
    for (int x = 12; x < 100; ++x) {
      const double expected = value((x + 0.5 - to.x) * 64 / to.width, (y + 0.5 - to.y) * 64 / to.height);
      ASSERT_NEAR(bent(y, x)[1], expected, 2e-3) << x << ", " << y;
    }
}

TEST(MeshWarp, ConstantsStayConstantAndOpaqueStaysOpaque) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const cv::Size in(random.whole(3, 70), random.whole(3, 70)), out(random.whole(3, 70), random.whole(3, 70));
    const int columns = random.whole(2, 12), rows = random.whole(2, 12);
    const MeshWarp warp(jittered(columns, rows, outline_of(in), random),
                        jittered(columns, rows, outline_of(out), random), {kSplines[seed % 3], PassOrder::kAuto});
    const Pixel color(0.7F, 0.3F, 1.9F, 1);
    const Image bent = warp.apply(Image(in, color), out);
    for (const Pixel& pixel : bent)
      for (int c = 0; c < 4; ++c) ASSERT_NEAR(pixel[c], color[c], 1e-5F);
  }
}

TEST(MeshWarp, SameBytesForAnyNumberOfThreads) {
  Random random(3);
  const cv::Size size(150, 130);
  const Mesh from = jittered(9, 8, outline_of(size), random), to = jittered(9, 8, outline_of(size), random);
  const Image image = random_image(size, 3);
  for (const PassOrder order : kOrders) {
    test::set_threads(1);
    const Image one = MeshWarp(from, to, {MeshSpline::kMonotone, order}).apply(image, size);
    for (const int threads : {2, 5}) {
      test::set_threads(threads);
      EXPECT_TRUE(same_bits(MeshWarp(from, to, {MeshSpline::kMonotone, order}).apply(image, size), one));
    }
  }
  test::set_threads(0);
}

TEST(MeshWarp, InterceptsOfOrderedVerticesAreInOrderEverywhere) {
  int meshes = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int columns = random.whole(2, 9), rows = random.whole(2, 9);
    const cv::Rect2d outline(0, 0, 100, 80);
    Mesh mesh = waved(columns, rows, outline, random, random.between(0, 1.5));
    if (seed % 2 == 0)
      for (int row = 1; row < rows - 1; ++row)
        for (int column = 1; column < columns - 1; ++column)
          mesh.at(column, row) +=
              cv::Point2d(random.between(-0.3, 0.3) * 100 / columns, random.between(-0.3, 0.3) * 80 / rows);
    if (!find_folds(mesh).empty()) continue;
    ++meshes;
    std::vector<double> along, across;
    for (int column = 0; column < columns; ++column)
      for (int row = 0; row < rows; ++row) {
        along.push_back(mesh.at(column, row).y);
        across.push_back(mesh.at(column, row).x);
      }
    const CurveFamily curves(MeshSpline::kMonotone, static_cast<std::size_t>(rows), along, across);
    CurveFamily::Hints hints(curves.curves(), 0);
    std::vector<double> places(curves.curves());
    for (int i = 0; i < 50; ++i) {
      const double y = random.between(0, 80);
      curves.intercepts(y, hints, places);
      for (std::size_t c = 1; c < places.size(); ++c) ASSERT_LT(places[c - 1], places[c]) << "at y = " << y;
      const auto any = static_cast<std::size_t>(random.whole(0, columns - 1));
      ASSERT_EQ(curves.intercept(any, y, hints), places[any]);
    }
  }
  EXPECT_GT(meshes, 1500) << "too few of the random meshes are in order";
}

/// Two passes have no fold if each one rises along all of its scanlines. With rows first, the source's y is the place
/// between the passes and must rise down every output column. Among output places with the same y between the passes,
/// the source's x must rise with x. Differences of a map are no test: where the map shears across a kink, they change
/// sign although the map does not fold.
void expect_injective(const MeshWarp& warp, cv::Size size, Random& random) {
  const bool turned = warp.order() == PassOrder::kColumnsFirst;
  const double width = turned ? size.height : size.width, height = turned ? size.width : size.height;
  const auto source = [&](double x, double y) {
    const cv::Point2d at = warp.source_of(turned ? cv::Point2d(y, x) : cv::Point2d(x, y));
    return turned ? cv::Point2d(at.y, at.x) : at;
  };
  for (int i = 0; i < 10; ++i) {
    const double x = random.between(0, width);
    double before = -1e-9;
    for (double y = 0; y <= height; y += 0.5) {
      const double between = source(x, y).y;
      ASSERT_GT(between, before) << "at (" << x << ", " << y << ")";
      before = between;
    }
  }
  for (int i = 0; i < 4; ++i) {
    const double between = random.between(0, height);
    double before = -1e-9;
    for (double x = 0.5; x < width; x += 0.5) {
      double low = 0, high = height;
      for (int step = 0; step < 45; ++step) {
        const double middle = (low + high) / 2;
        (source(x, middle).y < between ? low : high) = middle;
      }
      const double from = source(x, low).x;
      ASSERT_GT(from, before) << "at x = " << x << ", " << between << " between the passes";
      before = from;
    }
  }
}

TEST(MeshWarp, FoldsOnlyIfTheVerticesFold) {
  int meshes = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int columns = random.whole(3, 9), rows = random.whole(3, 9);
    const cv::Size size(48, 40);
    const Mesh from = waved(columns, rows, outline_of(size), random, random.between(0, 1)),
               to = waved(columns, rows, outline_of(size), random, random.between(0, 1));
    const MeshWarp warp(from, to);
    if (!find_folds(from).empty() || !find_folds(to).empty() ||
        !find_folds(intermediate_mesh(warp.from(), warp.to(), warp.order())).empty())
      continue;
    ++meshes;
    expect_injective(warp, size, random);
  }
  EXPECT_GT(meshes, 100);
}

TEST(MeshWarp, MapIsSourceOfAtPixelCentres) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const cv::Size in(50, 40), out(45, 60);
    const MeshWarp warp(jittered(6, 7, outline_of(in), random), jittered(6, 7, {3.5, -4, 40, 70}, random),
                        {kSplines[seed % 3], kOrders[seed % 2]});
    const Map map = warp.map(out);
    for (int i = 0; i < 40; ++i) {
      const int x = random.whole(0, out.width - 1), y = random.whole(0, out.height - 1);
      const cv::Point2d expected = warp.source_of({x + 0.5, y + 0.5});
      if (std::isnan(expected.x)) {
        ASSERT_TRUE(std::isnan(map(y, x)[0]));
        ASSERT_TRUE(x + 0.5 < 3.5 || x + 0.5 > 43.5);
      } else {
        ASSERT_NEAR(map(y, x)[0], expected.x, 1e-4);
        ASSERT_NEAR(map(y, x)[1], expected.y, 1e-4);
      }
    }
  }
}

TEST(MeshWarp, VerticesGoToTheirPlaces) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const cv::Rect2d outline(0, 0, 100, 80);
    const Mesh from = jittered(7, 6, outline, random, 0.2), to = jittered(7, 6, outline, random, 0.2);
    const MeshWarp warp(from, to, {kSplines[seed % 3], kOrders[seed % 2]});
    for (std::size_t i = 0; i < from.vertices.size(); ++i) {
      const cv::Point2d found = warp.source_of(to.vertices[i]);
      ASSERT_NEAR(found.x, from.vertices[i].x, 1e-9);
      ASSERT_NEAR(found.y, from.vertices[i].y, 1e-9);
    }
  }
}

TEST(MeshWarp, BothOrdersAgreeIfColumnsAndRowsMoveIndependently) {
  Random random(5);
  const cv::Size size(60, 50);
  Mesh from = uniform_mesh(6, 5, outline_of(size)), to = from;
  std::vector<double> dx(6, 0), dy(5, 0);
  for (int i = 1; i < 5; ++i) dx[static_cast<std::size_t>(i)] = random.between(-4, 4);
  for (int i = 1; i < 4; ++i) dy[static_cast<std::size_t>(i)] = random.between(-4, 4);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column)
      to.at(column, row) += cv::Point2d(dx[static_cast<std::size_t>(column)], dy[static_cast<std::size_t>(row)]);
  Image image = random_image(size, 5);
  for (Pixel& pixel : image) pixel[3] = 1;  // alpha is clamped after each pass, which would make them differ
  const Image rows = MeshWarp(from, to, {MeshSpline::kMonotone, PassOrder::kRowsFirst}).apply(image, size);
  const Image columns = MeshWarp(from, to, {MeshSpline::kMonotone, PassOrder::kColumnsFirst}).apply(image, size);
  EXPECT_LT(largest_difference(rows, columns, {{0, 0}, size}), 2e-5);
}

/// Rows pushed to the right in the upper half and to the left in the lower one.
Mesh sheared(const cv::Rect2d& outline, double amount) {
  Mesh mesh = uniform_mesh(9, 9, outline);
  for (int row = 1; row < 8; ++row)
    for (int column = 1; column < 8; ++column) mesh.at(column, row).x += amount * std::sin(row * 0.785398);
  return mesh;
}

TEST(MeshWarp, AutoTakesTheOrderThatKeepsMoreArea) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const cv::Rect2d outline(0, 0, 90, 90);
    const MeshWarp warp(waved(7, 7, outline, random, 0.6), waved(7, 7, outline, random, 0.6));
    const PassOrder other = warp.order() == PassOrder::kRowsFirst ? PassOrder::kColumnsFirst : PassOrder::kRowsFirst;
    const bool folds = !find_folds(intermediate_mesh(warp.from(), warp.to(), warp.order())).empty();
    const bool other_folds = !find_folds(intermediate_mesh(warp.from(), warp.to(), other)).empty();
    EXPECT_LE(folds, other_folds);
    if (folds == other_folds) {
      EXPECT_LE(area_lost(warp.from(), warp.to(), warp.order()), area_lost(warp.from(), warp.to(), other));
    }
    EXPECT_GE(area_lost(warp.from(), warp.to(), warp.order()), 0);
    EXPECT_LE(area_lost(warp.from(), warp.to(), warp.order()), 1);
  }
  const Mesh even = uniform_mesh(9, 9, {0, 0, 90, 90});
  EXPECT_EQ(area_lost(even, sheared({0, 0, 90, 90}, 3), PassOrder::kRowsFirst), 0);
}

TEST(MeshWarp, FoldedPartsVanishAndAreNotMirrored) {
  const cv::Size size(60, 50);
  Image ramp(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) ramp(y, x) = {static_cast<float>(x) / 60, static_cast<float>(y) / 50, 0.5F, 1};
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh even = uniform_mesh(7, 2, outline_of(size));
    Mesh folded = even;
    for (int column = 1; column < 6; ++column)
      folded.at(column, 0).x = folded.at(column, 1).x = random.between(0, size.width);
    // Along a row, a ramp stays a ramp: it may stand still or jump (where the cubic rings a little), but it never
    // falls.
    const bool forth = seed % 2 == 0;
    const Image bent = MeshWarp(forth ? even : folded, forth ? folded : even, {kSplines[seed % 3], PassOrder::kAuto})
                           .apply(ramp, size);
    for (int y = 0; y < size.height; ++y)
      for (int x = 1; x < size.width; ++x) {
        ASSERT_GE(bent(y, x)[0], bent(y, x - 1)[0] - 0.03F) << x << ", " << y;
        ASSERT_NEAR(bent(y, x)[1], ramp(y, x)[1], 1e-5F);
      }
  }
  Mesh collapsed = uniform_mesh(5, 5, outline_of(size));
  for (int row = 1; row < 4; ++row)
    for (int column = 1; column < 4; ++column) collapsed.at(column, row) = {30, 25};
  const Mesh even = uniform_mesh(5, 5, outline_of(size));
  for (const MeshWarp& warp : {MeshWarp(even, collapsed), MeshWarp(collapsed, even), MeshWarp(collapsed, collapsed)})
    for (const Pixel& pixel : warp.apply(random_image(size, 6), size))
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
}

TEST(MeshWarp, TakesMeshesAndImagesOfEverySize) {
  Random random(7);
  for (const auto& [columns, rows, in, out] :
       {std::tuple{2, 2, cv::Size(1, 1), cv::Size(1, 1)}, std::tuple{500, 500, cv::Size(200, 150), cv::Size(160, 170)},
        std::tuple{2, 500, cv::Size(1, 300), cv::Size(300, 1)},
        std::tuple{40, 3, cv::Size(8192, 16), cv::Size(100, 8192)},
        std::tuple{20, 20, cv::Size(1, 1), cv::Size(64, 64)}}) {
    const MeshWarp warp(jittered(columns, rows, outline_of(in), random),
                        jittered(columns, rows, outline_of(out), random));
    const Image bent = warp.apply(Image(in, Pixel(0.5F, 0.25F, 1, 1)), out);
    ASSERT_EQ(bent.size(), out);
    for (const Pixel& pixel : bent) ASSERT_NEAR(pixel[1], 0.25F, 1e-5F);
  }
}

TEST(MeshWarp, ApplySamplesThePositionsOfTheMap) {
  const cv::Size size(120, 100);
  const auto value = [](double x, double y) { return 0.5 + 0.3 * std::sin(x / 11) * std::cos(y / 9); };
  Image image(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      image(y, x) = Pixel(1, 1, 1, 0) * static_cast<float>(value(x + 0.5, y + 0.5)) + Pixel(0, 0, 0, 1);
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const MeshWarp warp(jittered(8, 7, outline_of(size), random, 0.15), jittered(8, 7, outline_of(size), random, 0.15),
                        {kSplines[seed % 3], kOrders[seed % 2]});
    const Image bent = warp.apply(image, size);
    const Map map = warp.map(size);
    for (int y = 2; y < size.height - 2; ++y)
      for (int x = 2; x < size.width - 2; ++x)
        ASSERT_NEAR(bent(y, x)[0], value(map(y, x)[0], map(y, x)[1]), 0.01) << x << ", " << y;
  }
}

TEST(MeshWarp, LinearIsStraightBetweenVertices) {
  // 2 x 3 vertices, the middle row from y = 400 to 100: two straight pieces, 4:1 and 1:3.7.
  const cv::Size size(20, 512);
  Mesh from = uniform_mesh(2, 3, outline_of(size)), to = from;
  for (int column = 0; column < 2; ++column) {
    from.at(column, 1).y = 100;
    to.at(column, 1).y = 400;
  }
  const MeshWarp linear(from, to, {MeshSpline::kLinear, PassOrder::kRowsFirst});
  for (const double y : {0.0, 50.0, 100.0, 300.0, 399.0}) EXPECT_NEAR(linear.source_of({10, y}).y, y / 4, 1e-9);
  for (const double y : {400.0, 450.0, 512.0})
    EXPECT_NEAR(linear.source_of({10, y}).y, 100 + (y - 400) * 412 / 112, 1e-9);
  // The monotone spline bends, but does not stand still at the border.
  const MeshWarp monotone(from, to);
  EXPECT_GT(monotone.source_of({10, 20}).y, 20.0 / 4 * 0.4);
}

TEST(MeshWarp, RefusesInvalidMeshes) {
  const Mesh good = uniform_mesh(4, 3, {0, 0, 10, 10});
  Mesh nan = good, few = good, far = good;
  nan.at(1, 1).x = std::nan("");
  few.vertices.pop_back();
  far.at(1, 1).y = 1e13;
  for (const Mesh& bad : {nan, few, far, uniform_mesh(3, 4, {0, 0, 10, 10})}) {
    EXPECT_THROW(MeshWarp(good, bad), std::invalid_argument);
    EXPECT_THROW(MeshWarp(bad, good), std::invalid_argument);
  }
  EXPECT_THROW(MeshWarp(good, good).apply(Image(9, 10), {10, 10}), std::invalid_argument);
  EXPECT_THROW(MeshWarp(good, good).apply(Image(10, 10), {10, 10}, Border::kMirror), std::invalid_argument);
  EXPECT_THROW(MeshWarp(good, good).apply(Image(), {10, 10}), std::invalid_argument);
}

TEST(MeshValues, AreLinearInUniformMeshesAndContinueOutside) {
  const Mesh mesh = uniform_mesh(5, 4, {10, 10, 40, 30});
  std::vector<double> values;
  for (const cv::Point2d& vertex : mesh.vertices) values.push_back(0.01 * vertex.x + 0.002 * vertex.y);
  const MeshValues field(mesh, values);
  std::vector<float> row(60);
  field.row(20, row);
  for (int x = 10; x < 50; ++x) EXPECT_NEAR(row[static_cast<std::size_t>(x)], 0.01 * (x + 0.5) + 0.002 * 20.5, 1e-6);
  EXPECT_NEAR(row[0], 0.01 * 10 + 0.002 * 20.5, 1e-6);
  field.row(0, row);
  EXPECT_NEAR(row[30], 0.01 * 30.5 + 0.002 * 10, 1e-6);
  EXPECT_THROW(MeshValues(mesh, std::vector<double>(3)), std::invalid_argument);
}

}  // namespace
}  // namespace morphkit::warp
