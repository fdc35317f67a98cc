// The kernel against the reference, on every instruction set that this machine runs.

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/unit/warp/field/line_field_corpus.h"
#include "warp/field/line_field_tables.h"

namespace morphkit::warp {
namespace {

using test::FieldCase;
using test::FieldCaseMaker;
using test::FieldRow;
using test::reference_row;

constexpr int kWildCases = 400;

/// Worst distance from the reference; infinite if a value is not finite, or differs where it must be equal.
double worst_difference(const FieldRow& fast, const FieldRow& reference, double far_px) {
  double worst = 0;
  for (size_t t = 0; t < fast.maps.size(); ++t) {
    for (size_t i = 0; i < fast.maps[t].size(); ++i) {
      const cv::Vec2d f = fast.maps[t][i];
      const cv::Vec2d r = reference.maps[t][i];
      const bool far = std::max(std::abs(r[0]), std::abs(r[1])) >= far_px;
      const double difference = cv::norm(f - r);
      if (f == r) continue;  // includes floats that overflowed
      worst = far || !std::isfinite(difference) ? HUGE_VAL : std::max(worst, difference);
    }
  }
  return worst;
}

double worst_value_difference(const FieldRow& fast, const FieldRow& reference) {
  double worst = 0;
  for (size_t i = 0; i < fast.values.size(); ++i) {
    const double difference = std::abs(static_cast<double>(fast.values[i]) - static_cast<double>(reference.values[i]));
    worst = std::isnan(difference) ? HUGE_VAL : std::max(worst, difference);
  }
  return worst;
}

class LineFieldSimd : public hwy::TestWithParamTarget {
 protected:
  /// Compares one row. @return  how many pixels the kernel took from the reference.
  int compare_row(const detail::FieldTables& tables, const LineField& field, int y, int x_begin, int n,
                  FieldAccuracy accuracy = FieldAccuracy::kExact) {
    FieldRow fast(tables.targets(), n);
    const FieldRow reference = reference_row(field, y, x_begin, n);
    const int asked = detail::simd_evaluate(tables, fast.area(y, x_begin), accuracy, fast.views, &fast.value_view);
    const bool exact = accuracy == FieldAccuracy::kExact;
    EXPECT_LE(worst_difference(fast, reference, exact ? 0x1p15 : 0x1p16),
              exact ? kFieldTolerancePx : kAdaptiveTolerancePx)
        << "y " << y << " x " << x_begin << " n " << n;
    EXPECT_LE(worst_value_difference(fast, reference), exact ? 1e-4 : 1e-3)
        << "y " << y << " x " << x_begin << " n " << n;
    return asked;
  }
};

HWY_TARGET_INSTANTIATE_TEST_SUITE_P(LineFieldSimd);

TEST_P(LineFieldSimd, AgreesWithTheReferenceOnWildSets) {
  for (unsigned seed = 1; seed <= kWildCases && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    const FieldCase set = make.wild();
    const detail::FieldTables tables(set.lines, set.targets);
    const LineField field(set.lines, set.targets);
    compare_row(tables, field, 10, 0, 70);  // where many lines meet
    compare_row(tables, field, make.integer(0, set.height - 1), make.integer(-100, set.width), make.integer(0, 67));
    const Line& line = set.lines[0].output;
    compare_row(tables, field, static_cast<int>(std::floor(line.p.y)), static_cast<int>(std::floor(line.p.x)) - 40, 80);
  }
}

TEST_P(LineFieldSimd, AdaptiveAgreesWithTheReferenceOnWildSets) {
  for (unsigned seed = 1; seed <= kWildCases / 4 && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    const FieldCase set = make.wild();
    const detail::FieldTables tables(set.lines, set.targets);
    const LineField field(set.lines, set.targets);
    compare_row(tables, field, 10, 0, 70, FieldAccuracy::kAdaptive);
    compare_row(tables, field, make.integer(0, set.height - 1), 0, set.width, FieldAccuracy::kAdaptive);
  }
}

/// Sets that people draw: chains, crossings, thousands of short lines; every a and b. On all rows.
TEST_P(LineFieldSimd, AdaptiveAgreesOnChainsCrossingsAndCrowds) {
  struct Crowd {
    int lines;
    double length_px, move_px;
    bool chained;
  };
  unsigned seed = 500;
  for (const Crowd& crowd :
       {Crowd{12, 300, 30, true}, Crowd{60, 60, 10, true}, Crowd{30, 200, 40, false}, Crowd{1500, 12, 6, false}}) {
    for (const LineWeight weight : {LineWeight{0, 1, 0}, LineWeight{0, 4, 0.2}, LineWeight{1, 2, 0},
                                    LineWeight{10, 1.5, 0.5}, LineWeight{100, 3, 1}, LineWeight{0.3, 0.5, 0}}) {
      SCOPED_TRACE(testing::Message() << "seed " << ++seed << " lines " << crowd.lines << " a " << weight.a << " b "
                                      << weight.b);
      FieldCaseMaker make(seed);
      std::vector<FieldLine> lines;
      cv::Point2d at{100, 80};
      cv::Point2d moved = at + make.within(crowd.move_px);
      for (int i = 0; i < crowd.lines; ++i) {
        const double angle_rad = make.uniform(0, 6.3);
        cv::Point2d end = at + crowd.length_px * cv::Point2d(std::cos(angle_rad), std::sin(angle_rad));
        end = {std::clamp(end.x, 0.0, 300.0), std::clamp(end.y, 0.0, 200.0)};
        const cv::Point2d end_moved = end + make.within(crowd.move_px);
        if (at != end) lines.push_back({{at, end}, {{moved, end_moved}}, weight, LineScale::kAlong, 0});
        at = crowd.chained ? end : cv::Point2d(make.uniform(0, 300), make.uniform(0, 200));
        moved = crowd.chained ? end_moved : at + make.within(crowd.move_px);
      }
      const detail::FieldTables tables(lines, 1);
      const LineField field(lines, 1);
      for (int y = 0; y<96; y += crowd.lines> 100 ? 13 : 1)
        compare_row(tables, field, y, 64, 160, FieldAccuracy::kAdaptive);
      if (HasFailure()) return;
    }
  }
}

TEST_P(LineFieldSimd, AgreesOnWholeRowsOf4K) {
  for (unsigned seed = 1001; seed <= 1006; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    FieldCase set = make.ordinary(3840, 2160, 25, 2, {make.integer(0, 1) * 1.0, make.uniform(0.5, 4), 0.3}, 300);
    const detail::FieldTables tables(set.lines, 2);
    compare_row(tables, LineField(set.lines, 2), make.integer(0, 2159), 0, 3840);
  }
}

TEST_P(LineFieldSimd, WritesEveryWidthAndNothingBesideIt) {
  const FieldCase set = FieldCaseMaker(5).ordinary(200, 100, 20, 3, {0, 1.5, 0.2}, 20);
  const LineField field(set.lines, 3);
  for (int n = 0; n <= 67; ++n) {
    // Guards on both sides of every row.
    FieldRow row(3, n + 2);
    std::vector<Map> inner;
    for (const Map& view : row.views) inner.emplace_back(view.colRange(1, n + 1));
    cv::Mat1f inner_values = row.value_view.colRange(1, n + 1);
    field.evaluate({13, 40, n, 1}, FieldAccuracy::kExact, inner, &inner_values);
    const FieldRow reference = reference_row(field, 40, 13, n);
    for (size_t t = 0; t < 3; ++t) {
      EXPECT_EQ(row.maps[t].front(), MapPoint(-7, -7)) << n;
      EXPECT_EQ(row.maps[t].back(), MapPoint(-7, -7)) << n;
      for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        EXPECT_LE(cv::norm(cv::Vec2d(row.maps[t][i + 1]) - cv::Vec2d(reference.maps[t][i])), kFieldTolerancePx) << n;
      }
    }
    EXPECT_EQ(row.values.front(), -7);
    EXPECT_EQ(row.values.back(), -7);
  }
}

TEST_P(LineFieldSimd, ResultsDoNotDependOnTheArea) {
  constexpr int kWidth = 150, kHeight = 70;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    const FieldCase set = make.wild();
    const LineField field(set.lines, set.targets);
    const FieldAccuracy accuracy = seed % 2 == 0 ? FieldAccuracy::kExact : FieldAccuracy::kAdaptive;
    const cv::Point origin(make.integer(-70, 70), make.integer(-70, 70));
    std::vector<Map> whole, pieces;
    for (int t = 0; t < set.targets; ++t) {
      whole.emplace_back(kHeight, kWidth);
      pieces.emplace_back(kHeight, kWidth);
    }
    cv::Mat1f whole_values(kHeight, kWidth), piece_values(kHeight, kWidth);
    field.evaluate({origin, cv::Size(kWidth, kHeight)}, accuracy, whole, &whole_values);
    const int x = make.integer(1, kWidth - 1), y = make.integer(1, kHeight - 1);
    for (const cv::Rect& piece : {cv::Rect(0, 0, x, y), cv::Rect(x, 0, kWidth - x, y), cv::Rect(0, y, x, kHeight - y),
                                  cv::Rect(x, y, kWidth - x, kHeight - y)}) {
      std::vector<Map> views;
      for (const Map& map : pieces) views.emplace_back(map(piece));
      cv::Mat1f values = piece_values(piece);
      field.evaluate(piece + origin, accuracy, views, &values);
    }
    for (size_t t = 0; t < whole.size(); ++t)
      EXPECT_EQ(std::memcmp(whole[t].data, pieces[t].data, kWidth * kHeight * sizeof(MapPoint)), 0);
    EXPECT_EQ(std::memcmp(whole_values.data, piece_values.data, kWidth * kHeight * sizeof(float)), 0);
  }
}

TEST_P(LineFieldSimd, OrdinarySetsRarelyNeedTheReference) {
  for (const LineWeight weight : {LineWeight{1, 2, 0}, LineWeight{1, 1.5, 0.2}, LineWeight{0.01, 1, 0.5},
                                  LineWeight{10, 1.3, 1}, LineWeight{1, 4, 0}, LineWeight{0.5, 0.5, 0}}) {
    for (const int lines : {1, 10, 50, 100}) {
      SCOPED_TRACE(testing::Message() << "a " << weight.a << " b " << weight.b << " lines " << lines);
      const FieldCase set = FieldCaseMaker(77).ordinary(1920, 1080, lines, 2, weight, 60);
      const detail::FieldTables tables(set.lines, 2);
      // Two tiles where a hundred lines have about equal weights and displacements hundreds of px apart.
      EXPECT_LE(compare_row(tables, LineField(set.lines, 2), 540, 0, 1920), 2 * kFieldTile);
    }
  }
}

TEST_P(LineFieldSimd, OnlyPixelsOnALineNeedTheReferenceWithoutA) {
  FieldCase set = FieldCaseMaker(78).ordinary(1920, 1080, 30, 2, {0, 2, 0}, 60);
  const double y = 300.5;
  set.lines[0].output = {{100.5, y}, {163.5, y}};
  for (Line& target : set.lines[0].targets) target = {{90, 290}, {170, 310}};
  const detail::FieldTables tables(set.lines, 2);
  EXPECT_EQ(compare_row(tables, LineField(set.lines, 2), 300, 0, 1920), 64);
}

TEST_P(LineFieldSimd, PixelsBeyondFloatPrecisionComeFromTheReference) {
  // A tiny line stretched to the size of the frame beside a plain line: a million px of difference.
  FieldCase set = FieldCaseMaker(79).ordinary(640, 480, 2, 1, {1, 1, 0}, 5);
  set.lines[0].output = {{300, 200}, {300.001, 200}};
  set.lines[0].targets[0] = {{0, 0}, {640, 480}};
  const detail::FieldTables tables(set.lines, 1);
  EXPECT_GT(compare_row(tables, LineField(set.lines, 1), 100, 0, 640), 500);
}

/// Even if distance hardly matters elsewhere.
TEST_P(LineFieldSimd, APixelOnALineFollowsItEvenWithoutFalloff) {
  for (const double b : {0.0, 1e-5}) {
    const std::vector<FieldLine> lines = {
        {{{10.5, 50.5}, {200.5, 50.5}}, {{{10.5, 60.5}, {200.5, 60.5}}}, {0, b, 0}, LineScale::kAlong, 0},
        {{{30, 400}, {90, 420}}, {{{30, 400}, {90, 420}}}, {0, b, 0}, LineScale::kAlong, 0}};
    for (const FieldAccuracy accuracy : {FieldAccuracy::kExact, FieldAccuracy::kAdaptive})
      compare_row(detail::FieldTables(lines, 1), LineField(lines, 1), 50, 0, 260, accuracy);
  }
}

TEST_P(LineFieldSimd, ATinyLineBesideALineStaysFinite) {
  for (const double beside : {0.0, 5e-7, 9e-7, 1e-5}) {
    const std::vector<FieldLine> lines = {{{{100, 48.5 + beside}, {400, 48.5 + beside}},
                                           {{{110, 58.5 + beside}, {410, 58.5 + beside}}},
                                           {0, 8, 0},
                                           LineScale::kAlong,
                                           0}};
    compare_row(detail::FieldTables(lines, 1), LineField(lines, 1), 48, 64, 360);
  }
}

TEST_P(LineFieldSimd, SteepFalloffStaysFinite) {
  for (const double far : {1e3, 1e6, 1e9}) {
    const std::vector<FieldLine> lines = {
        {{{far, 0}, {far, 7}}, {{{far - 3, 0}, {far - 3, 7}}}, {0, 8, 1}, LineScale::kAlong, 1},
        {{{0, -far}, {0.01, -far}}, {{{1, -far}, {1.01, -far}}}, {1, 8, 1}, LineScale::kAlong, 2},
        {{{1.5, 0.5 + 1e-3}, {1.5, 0.5 + 1e-3}}, {{{9, 9}, {9, 9}}}, {0, 8, 0}, LineScale::kAlong, 3}};
    const detail::FieldTables tables(lines, 1);
    compare_row(tables, LineField(lines, 1), 0, 0, 128);
    compare_row(tables, LineField(lines, 1), 500, -5000, 128);
    const std::span two(lines.data(), 2);
    compare_row(detail::FieldTables(two, 1), LineField(two, 1), 0, 0, 128);
  }
}

}  // namespace
}  // namespace morphkit::warp
