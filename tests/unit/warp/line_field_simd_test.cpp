// The kernel against the reference, on every instruction set that this machine runs.

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/unit/warp/line_field_corpus.h"
#include "warp/line_field_tables.h"

namespace morphkit::warp {
namespace {

constexpr int kWildCases = 400;

struct Row {
  Row(int targets, int n) : maps(targets, std::vector<MapPoint>(n, MapPoint(-7, -7))), values(n, -7) {
    for (auto& map : maps) spans.emplace_back(map);
  }
  std::vector<std::vector<MapPoint>> maps;
  std::vector<std::span<MapPoint>> spans;
  std::vector<float> values;
};

/// Worst distance from the reference; infinite if something is not finite, or not equal where it must be.
double worst_difference(const Row& fast, const Row& reference) {
  double worst = 0;
  for (size_t t = 0; t < fast.maps.size(); ++t) {
    for (size_t i = 0; i < fast.maps[t].size(); ++i) {
      const cv::Vec2d f = fast.maps[t][i];
      const cv::Vec2d r = reference.maps[t][i];
      const bool far = std::max(std::abs(r[0]), std::abs(r[1])) >= 0x1p14;
      const double difference = cv::norm(f - r);
      if (f == r) continue;  // includes what overflowed a float
      worst = far || !std::isfinite(difference) ? HUGE_VAL : std::max(worst, difference);
    }
  }
  return worst;
}

double worst_value_difference(const Row& fast, const Row& reference) {
  double worst = 0;
  for (size_t i = 0; i < fast.values.size(); ++i) {
    const double difference = std::abs(static_cast<double>(fast.values[i]) - static_cast<double>(reference.values[i]));
    worst = std::isnan(difference) ? HUGE_VAL : std::max(worst, difference);
  }
  return worst;
}

class LineFieldSimd : public hwy::TestWithParamTarget {
 protected:
  /// Compares one row and returns how many pixels the kernel asked the reference for.
  int compare_row(const detail::FieldTables& tables, const LineField& field, int y, int x_begin, int n) {
    Row fast(tables.targets(), n);
    Row reference(tables.targets(), n);
    const int asked = detail::simd_row(tables, y, x_begin, fast.spans, fast.values);
    field.reference_row(y, x_begin, reference.spans, reference.values);
    EXPECT_LE(worst_difference(fast, reference), kFieldTolerancePx) << "y " << y << " x " << x_begin << " n " << n;
    EXPECT_LE(worst_value_difference(fast, reference), 1e-4) << "y " << y << " x " << x_begin << " n " << n;
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

TEST_P(LineFieldSimd, AgreesOnWholeRowsOf4K) {
  for (unsigned seed = 1001; seed <= 1006; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    FieldCase set = make.ordinary(3840, 2160, 25, 2, {make.integer(0, 1) * 1.0, make.uniform(0.5, 4), 0.3}, 300);
    const detail::FieldTables tables(set.lines, 2);
    compare_row(tables, LineField(set.lines, 2), make.integer(0, 2159), 0, 3840);
  }
}

TEST_P(LineFieldSimd, EveryWidthAndNothingBeside) {
  const FieldCase set = FieldCaseMaker(5).ordinary(200, 100, 20, 3, {0, 1.5, 0.2}, 20);
  const LineField field(set.lines, 3);
  for (int n = 0; n <= 67; ++n) {
    // Guards on both sides of every span.
    Row row(3, n + 2);
    std::vector<std::span<MapPoint>> inner;
    for (const auto& span : row.spans) inner.push_back(span.subspan(1, n));
    field.row(40, 13, inner, std::span(row.values).subspan(1, n));
    Row reference(3, n);
    field.reference_row(40, 13, reference.spans, reference.values);
    for (int t = 0; t < 3; ++t) {
      EXPECT_EQ(row.maps[t].front(), MapPoint(-7, -7)) << n;
      EXPECT_EQ(row.maps[t].back(), MapPoint(-7, -7)) << n;
      for (int i = 0; i < n; ++i) {
        EXPECT_LE(cv::norm(cv::Vec2d(row.maps[t][i + 1]) - cv::Vec2d(reference.maps[t][i])), kFieldTolerancePx) << n;
      }
    }
    EXPECT_EQ(row.values.front(), -7);
    EXPECT_EQ(row.values.back(), -7);
  }
}

TEST_P(LineFieldSimd, CutsDoNotShow) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    FieldCaseMaker make(seed);
    const FieldCase set = make.wild();
    const LineField field(set.lines, set.targets);
    Row whole(set.targets, 300);
    field.row(10, -64, whole.spans, whole.values);
    Row pieces(set.targets, 300);
    for (int begin = 0; begin < 300;) {
      const int n = std::min(make.integer(1, 130), 300 - begin);
      std::vector<std::span<MapPoint>> cut;
      for (const auto& span : pieces.spans) cut.push_back(span.subspan(begin, n));
      field.row(10, begin - 64, cut, std::span(pieces.values).subspan(begin, n));
      begin += n;
    }
    for (int t = 0; t < set.targets; ++t) {
      EXPECT_EQ(std::memcmp(whole.maps[t].data(), pieces.maps[t].data(), 300 * sizeof(MapPoint)), 0);
    }
    EXPECT_EQ(std::memcmp(whole.values.data(), pieces.values.data(), 300 * sizeof(float)), 0);
  }
}

TEST_P(LineFieldSimd, NumberOfTargetsDoesNotMatter) {
  const FieldCase set = FieldCaseMaker(9).ordinary(640, 480, 30, 5, {1, 1.3, 0.2}, 30);
  Row all(5, 640);
  LineField(set.lines, 5).row(100, 0, all.spans, all.values);
  for (int targets = 1; targets <= 4; ++targets) {
    std::vector<FieldLine> lines = set.lines;
    for (FieldLine& line : lines) line.targets.resize(static_cast<size_t>(targets));
    Row some(targets, 640);
    LineField(lines, targets).row(100, 0, some.spans);
    for (int t = 0; t < targets; ++t) {
      EXPECT_EQ(std::memcmp(some.maps[t].data(), all.maps[t].data(), 640 * sizeof(MapPoint)), 0) << targets;
    }
  }
}

TEST_P(LineFieldSimd, OrdinarySetsDoNotNeedTheReference) {
  for (const LineWeight weight : {LineWeight{1, 2, 0}, LineWeight{1, 1.5, 0.2}, LineWeight{0.01, 1, 0.5},
                                  LineWeight{10, 1.3, 1}, LineWeight{1, 4, 0}, LineWeight{0.5, 0.5, 0}}) {
    for (const int lines : {1, 10, 50, 100}) {
      SCOPED_TRACE(testing::Message() << "a " << weight.a << " b " << weight.b << " lines " << lines);
      const FieldCase set = FieldCaseMaker(77).ordinary(1920, 1080, lines, 2, weight, 60);
      const detail::FieldTables tables(set.lines, 2);
      EXPECT_EQ(compare_row(tables, LineField(set.lines, 2), 540, 0, 1920), 0);
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

TEST_P(LineFieldSimd, WhatFloatCannotHoldIsTakenFromTheReference) {
  // A hair stretched to the size of the frame beside a plain line: a million px of difference.
  FieldCase set = FieldCaseMaker(79).ordinary(640, 480, 2, 1, {1, 1, 0}, 5);
  set.lines[0].output = {{300, 200}, {300.001, 200}};
  set.lines[0].targets[0] = {{0, 0}, {640, 480}};
  const detail::FieldTables tables(set.lines, 1);
  EXPECT_GT(compare_row(tables, LineField(set.lines, 1), 100, 0, 640), 500);
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
