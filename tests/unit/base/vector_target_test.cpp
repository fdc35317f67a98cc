#include "base/vector_target.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace morphkit::test {
namespace {

TEST(VectorTarget, IsOneThatThisMachineRuns) {
  const std::string name = vector_target();
  bool runs = false;
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    runs = runs || name == hwy::TargetName(rest & -rest);
  }
  EXPECT_TRUE(runs) << name;
}

}  // namespace
}  // namespace morphkit::test
