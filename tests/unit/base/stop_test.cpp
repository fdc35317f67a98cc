// Long work is given up when it is asked to.

#include "base/stop.h"

#include <atomic>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/parallel.h"
#include "tests/support/errors.h"

namespace morphkit::test {
namespace {

TEST(Stop, NothingIsAskedOutsideOfAScope) {
  EXPECT_FALSE(stop_question());
  EXPECT_NO_THROW(stop_if_asked());
}

TEST(Stop, ScopesNest) {
  const StopScope never([] { return false; });
  EXPECT_NO_THROW(stop_if_asked());
  {
    const StopScope always([] { return true; });
    EXPECT_EQ(error_of([] { stop_if_asked(); }).kind(), ErrorKind::kInterrupted);
  }
  EXPECT_NO_THROW(stop_if_asked());
}

TEST(Stop, RowsThatHaveNotStartedAreGivenUp) {
  for (const int threads : {1, 2, 5}) {
    const Workers workers(threads);
    const Workers::Scope computing(workers);
    std::atomic<int> begun = 0;
    const StopScope stopping([&] { return begun >= 3; });
    const Error error = error_of([&] {
      for_rows(
          1000, [&](int, int) { ++begun; }, 1);
    });
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
    EXPECT_GE(begun, 3);
    EXPECT_LE(begun, 2 + threads);
  }
}

}  // namespace
}  // namespace morphkit::test
