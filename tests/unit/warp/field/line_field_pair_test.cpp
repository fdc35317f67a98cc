// The kernel handles targets in pairs, on every instruction set that this machine runs.

#include <gtest/gtest.h>
#include <hwy/tests/hwy_gtest.h>

#include <cstring>

#include "tests/unit/warp/field/line_field_corpus.h"

namespace morphkit::warp {
namespace {

using test::FieldCase;
using test::FieldCaseMaker;
using test::FieldRow;

class LineFieldPair : public hwy::TestWithParamTarget {};

HWY_TARGET_INSTANTIATE_TEST_SUITE_P(LineFieldPair);

TEST_P(LineFieldPair, ATargetDoesNotDependOnTheOthers) {
  const FieldCase set = FieldCaseMaker(9).ordinary(640, 480, 30, 6, {1, 1.3, 0.2}, 30);
  FieldRow all(6, 640);
  LineField(set.lines, 6).evaluate(all.area(100, 0), FieldAccuracy::kExact, all.views);
  for (int targets = 2; targets <= 4; targets += 2) {
    std::vector<FieldLine> lines = set.lines;
    for (FieldLine& line : lines) line.targets.resize(static_cast<size_t>(targets));
    FieldRow some(targets, 640);
    LineField(lines, targets).evaluate(some.area(100, 0), FieldAccuracy::kExact, some.views);
    for (size_t t = 0; t < static_cast<size_t>(targets); ++t) {
      EXPECT_EQ(std::memcmp(some.maps[t].data(), all.maps[t].data(), 640 * sizeof(MapPoint)), 0) << targets;
    }
  }
}

}  // namespace
}  // namespace morphkit::warp
