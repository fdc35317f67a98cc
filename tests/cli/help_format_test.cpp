#include "cli/help_format.h"

#include <gtest/gtest.h>

namespace morphkit::cli {
namespace {

TEST(Wrapped, BreaksAtSpacesAndKeepsLongWords) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("extraordinary word", 4), "extraordinary\nword");
  EXPECT_EQ(wrapped("a\nb\n", 10), "a\nb\n");
  EXPECT_EQ(wrapped("", 10), "");
}

}  // namespace
}  // namespace morphkit::cli
