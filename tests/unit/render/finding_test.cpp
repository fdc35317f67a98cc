#include "morph/render/finding.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace morphkit::render {
namespace {

using Kind = Finding::Kind;

TEST(Finding, EachKindHasItsName) {
  EXPECT_STREQ(name_of(Kind::kCrossing), "crossing");
  EXPECT_STREQ(name_of(Kind::kFold), "fold");
  EXPECT_STREQ(name_of(Kind::kBottleneck), "bottleneck");
  std::set<std::string> names;
  for (const Kind kind : {Kind::kCrossing, Kind::kTwins, Kind::kOutsideImage, Kind::kOutsideCanvas, Kind::kFold,
                          Kind::kMeshFold, Kind::kBottleneck})
    names.insert(name_of(kind));
  EXPECT_EQ(names.size(), 7u);
}

}  // namespace
}  // namespace morphkit::render
