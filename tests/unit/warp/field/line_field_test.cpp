#include "warp/field/line_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/unit/warp/field/line_field_corpus.h"

namespace morphkit::warp {
namespace {

using test::evaluated_row;
using test::FieldCase;
using test::FieldCaseMaker;
using test::FieldRow;
using test::reference_row;

FieldLine pair(Line output, Line target, LineWeight weight = {}, LineScale scale = LineScale::kAlong,
               double value = 0) {
  return {output, {target}, weight, scale, value};
}

cv::Point2d point_of(const MapPoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1])};
}

cv::Point2d turned(const cv::Point2d& p, double angle_rad) {
  return {std::cos(angle_rad) * p.x - std::sin(angle_rad) * p.y, std::sin(angle_rad) * p.x + std::cos(angle_rad) * p.y};
}

/// Beier and Neely 1992, equations 1 to 3, written out: the position to which a single pair moves X.
cv::Point2d pair_image(const cv::Point2d& x, const Line& from, const Line& to, LineScale scale) {
  const cv::Point2d d = from.q - from.p;
  const cv::Point2d d_to = to.q - to.p;
  const double u = (x - from.p).dot(d) / d.dot(d);
  const double v = (x - from.p).dot({-d.y, d.x}) / cv::norm(d);
  const double across = scale == LineScale::kAlong ? v : v * cv::norm(d_to) / cv::norm(d);
  return to.p + u * d_to + across * cv::Point2d{-d_to.y, d_to.x} / cv::norm(d_to);
}

TEST(LineField, IdentityIsExact) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCase set = FieldCaseMaker(seed).wild();
    for (FieldLine& line : set.lines) std::fill(line.targets.begin(), line.targets.end(), line.output);
    const LineField field(set.lines, set.targets);
    const FieldRow fast = evaluated_row(field, 10, 0, 130);
    const FieldRow reference = reference_row(field, 10, 0, 130);
    for (int i = 0; i < 130; ++i) {
      const MapPoint centre{static_cast<float>(i) + 0.5f, 10.5f};
      ASSERT_EQ(fast.maps[0][i], centre);
      ASSERT_EQ(reference.maps[0][i], centre);
      ASSERT_EQ(fast.maps.back()[i], centre);
    }
  }
}

TEST(LineField, WithoutLinesIsTheIdentity) {
  const LineField field({}, 2);
  EXPECT_TRUE(field.empty());
  EXPECT_EQ(field.targets(), 2);
  const FieldRow row = evaluated_row(field, -3, -70, 100);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(row.maps[1][i], MapPoint(static_cast<float>(i) - 69.5f, -2.5f));
    EXPECT_EQ(row.values[i], 0.0f);
  }
  EXPECT_EQ(reference_row(field, -3, -70, 100).maps, row.maps);
}

TEST(LineField, OnePairIsItsAffineMap) {
  FieldCaseMaker make(11);
  for (int round = 0; round < 200; ++round) {
    const LineScale scale = round % 2 == 0 ? LineScale::kAlong : LineScale::kUniform;
    const FieldCase set = make.ordinary(640, 480, 1, 1, {make.uniform(0, 2), make.uniform(0.5, 4), 0.3}, 80);
    FieldLine line = set.lines[0];
    line.scale = scale;
    const LineField field({&line, 1}, 1);
    const int y = make.integer(0, 479);
    const FieldRow fast = evaluated_row(field, y, 0, 640);
    const FieldRow reference = reference_row(field, y, 0, 640);
    for (int i = 0; i < 640; ++i) {
      const cv::Point2d expected = pair_image({i + 0.5, y + 0.5}, line.output, line.targets[0], scale);
      // The output is float: half a unit in the last place for each coordinate, plus 1e-9 for the double arithmetic.
      const double rounding = (std::abs(expected.x) + std::abs(expected.y)) * 0x1p-24 + 1e-9;
      ASSERT_LE(cv::norm(point_of(reference.maps[0][i]) - expected), rounding) << "round " << round << " x " << i;
      ASSERT_LE(cv::norm(point_of(fast.maps[0][i]) - expected), kFieldTolerancePx) << "round " << round << " x " << i;
    }
  }
}

TEST(LineField, ReferenceMeetsHandComputedPositionsExactly) {
  // Twice as long along x: kAlong doubles x only, the similarity doubles both.
  const Line output{{0, 0}, {4, 0}};
  const Line target{{0, 0}, {8, 0}};
  const FieldLine along = pair(output, target);
  const FieldLine uniform = pair(output, target, {}, LineScale::kUniform);
  EXPECT_EQ(reference_row(LineField({&along, 1}, 1), 2, 1, 1).maps[0][0], MapPoint(3, 2.5f));
  EXPECT_EQ(reference_row(LineField({&uniform, 1}, 1), 2, 1, 1).maps[0][0], MapPoint(3, 5));
}

TEST(LineField, TwoPairsGiveTheWeightedMean) {
  // At (0.5, 0.5): distances 4 and 2 from two points; a = 0, b = 1 -> weights 1/4 and 1/2.
  const std::vector<FieldLine> lines = {
      pair({{4.5, 0.5}, {4.5, 0.5}}, {{10.5, 0.5}, {10.5, 0.5}}, {0, 1, 0}, LineScale::kAlong, 1),
      pair({{0.5, 2.5}, {0.5, 2.5}}, {{0.5, 5.5}, {0.5, 5.5}}, {0, 1, 0}, LineScale::kAlong, 4)};
  const LineField field(lines, 1);
  const FieldRow row = reference_row(field, 0, 0, 1);
  EXPECT_FLOAT_EQ(row.maps[0][0][0], 0.5f + 2.0f);
  EXPECT_FLOAT_EQ(row.maps[0][0][1], 0.5f + 2.0f);
  EXPECT_FLOAT_EQ(row.values[0], 3.0f);
}

/// A line `zoom` times as large, with the same weights.
FieldLine magnified(FieldLine line, double zoom) {
  line.output = {line.output.p * zoom, line.output.q * zoom};
  for (Line& target : line.targets) target = {target.p * zoom, target.q * zoom};
  line.weight.unit /= zoom;
  return line;
}

TEST(LineField, AMagnifiedViewWithItsUnitEqualsTheField) {
  // With odd zooms, the centre of pixel i of the frame is the centre of the middle one of `zoom` pixels.
  for (const int zoom : {3, 15, 16383}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(testing::Message() << "zoom " << zoom << " seed " << seed);
      FieldCaseMaker make(seed);
      FieldCase set = make.ordinary(320, 240, 9, 1, {}, 20);
      for (FieldLine& line : set.lines) {
        line.weight = {make.uniform(0, 30), make.uniform(0.5, 4), make.uniform(0, 1)};
        line.value = make.uniform(-1, 1);
      }
      std::vector<FieldLine> lines;
      for (const FieldLine& line : set.lines) lines.push_back(magnified(line, zoom));
      const LineField field(set.lines, 1), view(lines, 1);
      const int x = make.integer(0, 319), y = make.integer(0, 239);
      const FieldRow whole = reference_row(field, y, x, 1);
      const FieldRow seen = reference_row(view, y * zoom + zoom / 2, x * zoom + zoom / 2, 1);
      const FieldRow fast = evaluated_row(view, y * zoom + zoom / 2, x * zoom + zoom / 2, 1);
      // Positions are floats: half a unit in the last place of each, in px of the frame.
      const cv::Point2d expected = point_of(whole.maps[0][0]);
      const double rounding = (std::abs(expected.x) + std::abs(expected.y)) * 0x1p-23 + 1e-9;
      EXPECT_LE(cv::norm(point_of(seen.maps[0][0]) / zoom - expected), rounding);
      EXPECT_LE(cv::norm(point_of(fast.maps[0][0]) / zoom - expected), rounding + kFieldTolerancePx);
      EXPECT_NEAR(seen.values[0], whole.values[0], 1e-6);
    }
  }
}

TEST(LineField, RefusesInvalidUnits) {
  for (const double unit : {0.0, -1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    const FieldLine line = pair({{0, 0}, {4, 0}}, {{0, 0}, {8, 0}}, {1, 2, 0, unit});
    EXPECT_THROW(LineField({&line, 1}, 1), std::invalid_argument) << unit;
  }
}

TEST(LineField, DistanceIsToTheNearerEndBeyondTheLine) {
  // Beyond the end of a line, the distance to the end counts: weights 1/5 (3-4-5) and 1/5 from a point.
  const std::vector<FieldLine> lines = {pair({{0.5, 0.5}, {10.5, 0.5}}, {{0.5, 2.5}, {10.5, 2.5}}, {0, 1, 0}),
                                        pair({{18.5, 4.5}, {18.5, 4.5}}, {{18.5, 4.5}, {18.5, 4.5}}, {0, 1, 0})};
  const FieldRow row = reference_row(LineField(lines, 1), 4, 13, 1);
  EXPECT_FLOAT_EQ(row.maps[0][0][0], 13.5f);
  EXPECT_FLOAT_EQ(row.maps[0][0][1], 5.5f);
}

TEST(LineField, LongerLinesPullMoreWithP) {
  // Equal distances; length 8 against a point (length 1), p = 1, b = 1: weights 8 to 1.
  const std::vector<FieldLine> lines = {pair({{-3.5, 2.5}, {4.5, 2.5}}, {{-3.5, 11.5}, {4.5, 11.5}}, {1, 1, 1}),
                                        pair({{0.5, -1.5}, {0.5, -1.5}}, {{0.5, -1.5}, {0.5, -1.5}}, {1, 1, 1})};
  const FieldRow row = reference_row(LineField(lines, 1), 0, 0, 1);
  EXPECT_FLOAT_EQ(row.maps[0][0][1], 0.5f + 8.0f);
}

TEST(LineField, OnePointIsATranslation) {
  const FieldLine line = pair({{3, 4}, {3, 4}}, {{13.25, -1.5}, {13.25, -1.5}}, {0, 1.7, 1});
  const LineField field({&line, 1}, 1);
  for (const FieldRow& row : {evaluated_row(field, 3, 0, 100), reference_row(field, 3, 0, 100)}) {
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(row.maps[0][i], MapPoint(static_cast<float>(i) + 10.75f, -2.0f));
    }
  }
}

TEST(LineField, LineTurningThroughLengthZeroIsAPointAtItsPlace) {
  const FieldLine in_output = pair({{5, 5}, {5, 5}}, {{2, 9}, {4, 9}});  // midpoint moves by (-2, 4)
  const FieldLine in_target = pair({{4, 5}, {6, 5}}, {{3, 9}, {3, 9}});  // here too
  for (const FieldLine& line : {in_output, in_target}) {
    const LineField field({&line, 1}, 1);
    EXPECT_EQ(reference_row(field, 0, 0, 3).maps[0][1], MapPoint(-0.5f, 4.5f));
    EXPECT_EQ(evaluated_row(field, 0, 0, 3).maps[0][1], MapPoint(-0.5f, 4.5f));
  }
}

TEST(LineField, PixelsOnALineFollowItWithoutA) {
  // The first line lies on the pixel centres of row 7; others have large displacements elsewhere.
  const std::vector<FieldLine> lines = {pair({{2.5, 7.5}, {90.5, 7.5}}, {{12.5, 3.5}, {100.5, 3.5}}, {0, 0.5, 0}),
                                        pair({{0, 0}, {90, 20}}, {{500, 0}, {900, 400}}, {0, 0.5, 1}),
                                        pair({{40, 8}, {40, 8}}, {{0, 900}, {0, 900}}, {1, 2, 0})};
  const LineField field(lines, 1);
  for (const FieldRow& row : {evaluated_row(field, 7, 0, 95), reference_row(field, 7, 0, 95)}) {
    for (int i = 2; i <= 90; ++i) {
      if (i == 33 || i == 34) continue;  // beside the crossing with the second line, at x = 33.75
      EXPECT_EQ(row.maps[0][i], MapPoint(static_cast<float>(i) + 10.5f, 3.5f)) << i;
    }
  }
}

TEST(LineField, PixelOnSeveralLinesTakesTheirWeightedMean) {
  // Crossing at (8.5, 8.5), lengths 16 and 4, p = 0.5, b = 2: weights 16 to 4.
  const std::vector<FieldLine> lines = {pair({{0.5, 8.5}, {16.5, 8.5}}, {{10.5, 8.5}, {26.5, 8.5}}, {0, 2, 0.5}),
                                        pair({{8.5, 6.5}, {8.5, 10.5}}, {{8.5, 1.5}, {8.5, 5.5}}, {0, 2, 0.5}),
                                        pair({{9, 9}, {9, 9}}, {{99, 99}, {99, 99}}, {0, 2, 0.5})};
  const LineField field(lines, 1);
  for (const FieldRow& row : {evaluated_row(field, 8, 8, 1), reference_row(field, 8, 8, 1)}) {
    EXPECT_FLOAT_EQ(row.maps[0][0][0], 8.5f + 8.0f);
    EXPECT_FLOAT_EQ(row.maps[0][0][1], 8.5f - 1.0f);
  }
}

TEST(LineField, TranslatingOutputAndTargetsTranslatesTheField) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    FieldCase set = make.ordinary(200, 200, 12, 2, {make.uniform(0.1, 3), make.uniform(0.5, 4), 0.5}, 30);
    const FieldRow before = reference_row(LineField(set.lines, 2), 50, 0, 64);
    const cv::Point2d move{96, 32};
    for (FieldLine& line : set.lines) {
      line.output = {line.output.p + move, line.output.q + move};
      for (Line& target : line.targets) target = {target.p + move, target.q + move};
    }
    const FieldRow after = reference_row(LineField(set.lines, 2), 82, 96, 64);
    for (int i = 0; i < 64; ++i) {
      EXPECT_LE(cv::norm(point_of(after.maps[1][i]) - point_of(before.maps[1][i]) - move), 1e-4);
    }
  }
}

TEST(LineField, RotatingOutputAndTargetsRotatesTheField) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    FieldCase set = make.ordinary(200, 200, 12, 1, {make.uniform(0.1, 3), make.uniform(0.5, 4), 0.5}, 30);
    // About the centre of pixel (20, 50), which therefore stays in place.
    const cv::Point2d centre{20.5, 50.5};
    const cv::Point2d before = point_of(reference_row(LineField(set.lines, 1), 50, 20, 1).maps[0][0]);
    const double angle_rad = make.uniform(-3, 3);
    const auto turn = [&](const cv::Point2d& p) { return centre + turned(p - centre, angle_rad); };
    for (FieldLine& line : set.lines) {
      line.output = {turn(line.output.p), turn(line.output.q)};
      line.targets[0] = {turn(line.targets[0].p), turn(line.targets[0].q)};
    }
    const cv::Point2d after = point_of(reference_row(LineField(set.lines, 1), 50, 20, 1).maps[0][0]);
    EXPECT_LE(cv::norm(after - turn(before)), 1e-4);
  }
}

TEST(LineField, DisplacementLiesWithinTheBoxOfItsPairs) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    const FieldCase set = make.ordinary(300, 200, 8, 1, {make.uniform(0, 3), make.uniform(0.5, 4), 0.5}, 60);
    const FieldRow fast = evaluated_row(LineField(set.lines, 1), 77, 0, 300);
    // A hull is an intersection of half planes: in any direction, no displacement may exceed the largest of the pairs.
    for (int i = 0; i < 300; ++i) {
      const cv::Point2d x{i + 0.5, 77.5};
      for (int k = 0; k < 16; ++k) {
        const cv::Point2d direction = turned({1, 0}, k * CV_PI / 8);
        double furthest = -std::numeric_limits<double>::infinity();
        for (const FieldLine& line : set.lines) {
          furthest = std::max(furthest, direction.dot(pair_image(x, line.output, line.targets[0], line.scale)));
        }
        ASSERT_LE(direction.dot(point_of(fast.maps[0][i])), furthest + kFieldTolerancePx) << i;
      }
    }
  }
}

TEST(LineField, ValuesStayBetweenTheLeastAndTheLargest) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const FieldCase set = FieldCaseMaker(seed).wild();
    const auto [least, most] = std::minmax_element(
        set.lines.begin(), set.lines.end(), [](const FieldLine& l, const FieldLine& r) { return l.value < r.value; });
    const FieldRow row = evaluated_row(LineField(set.lines, set.targets), 10, 0, 200);
    for (const float value : row.values) {
      ASSERT_GE(value, static_cast<float>(least->value));
      ASSERT_LE(value, std::nextafter(static_cast<float>(most->value), HUGE_VALF));
    }
  }
}

TEST(LineField, BrokenContractsNameTheLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FieldLine good = pair({{0, 0}, {1, 1}}, {{0, 0}, {1, 2}});
  const auto expect_rejected = [&](const FieldLine& bad, const std::string& word) {
    const std::vector<FieldLine> lines = {good, bad};
    try {
      const LineField field(lines, 1);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("line 1: "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  expect_rejected(pair({{nan, 0}, {1, 1}}, good.output), "coordinates");
  expect_rejected(pair(good.output, {{0, HUGE_VAL}, {1, 1}}), "coordinates");
  expect_rejected(pair(good.output, {{0, 1e300}, {1, 1}}), "coordinates");
  expect_rejected(pair(good.output, good.output, {-1, 2, 0}), "a = ");
  expect_rejected(pair(good.output, good.output, {nan, 2, 0}), "a = ");
  expect_rejected(pair(good.output, good.output, {1, 8.5, 0}), "b = ");
  expect_rejected(pair(good.output, good.output, {1, -0.1, 0}), "b = ");
  expect_rejected(pair(good.output, good.output, {1, 2, 1.1}), "p = ");
  expect_rejected(pair(good.output, good.output, {1, 2, nan}), "p = ");
  expect_rejected(pair(good.output, good.output, {}, LineScale::kAlong, nan), "value");
  expect_rejected({good.output, {}, {}, LineScale::kAlong, 0}, "targets");
  EXPECT_THROW(LineField({}, 0), std::invalid_argument);
}

TEST(LineField, MapsMustMatch) {
  const FieldLine line = pair({{0, 0}, {1, 1}}, {{0, 0}, {1, 2}});
  const LineField field({&line, 1}, 1);
  FieldRow two(2, 5);
  EXPECT_THROW(field.evaluate({0, 0, 5, 1}, FieldAccuracy::kExact, two.views), std::invalid_argument);
  EXPECT_THROW(field.reference({0, 0, 5, 1}, {}), std::invalid_argument);
  FieldRow one(1, 5);
  EXPECT_THROW(field.evaluate({0, 0, 4, 1}, FieldAccuracy::kExact, one.views), std::invalid_argument);
  cv::Mat1f values(1, 4);
  EXPECT_THROW(field.evaluate({0, 0, 5, 1}, FieldAccuracy::kExact, one.views, &values), std::invalid_argument);
}

}  // namespace
}  // namespace morphkit::warp
