// The text by which a file says what it was made from.

#include "morph/media/made_from.h"

#include <gtest/gtest.h>

namespace morphkit::media {
namespace {

TEST(MadeFrom, DigestsAreThoseOfXxh64) {
  EXPECT_EQ(digest_of(""), "ef46db3751d8e999");
  EXPECT_EQ(digest_of("a"), "d24ec4f1a98c6e5b");
}

TEST(MadeFrom, TheMarkIsShortAndTellsTextsApart) {
  EXPECT_EQ(made_from_mark("a"), "morphkit, from d24ec4f1a98c6e5b");
  EXPECT_NE(made_from_mark("a"), made_from_mark("b"));
}

}  // namespace
}  // namespace morphkit::media
