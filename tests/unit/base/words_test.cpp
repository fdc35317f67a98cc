#include "base/words.h"

#include <gtest/gtest.h>

namespace morphkit::test {
namespace {

std::string meant(std::string_view word) {
  return nearest(word, std::vector<std::string>{"linear", "lanczos", "nearest", "in", "on"}).value_or("");
}

TEST(Words, LowerChangesLettersOfAsciiOnly) {
  EXPECT_EQ(lower("AbZ-09 \xC3\x84"), "abz-09 \xC3\x84");
}

TEST(Words, NearestForgivesInsertedDeletedReplacedAndSwappedLetters) {
  for (const char* word : {"linear", "linnear", "liear", "linaer", "lineer", "LINEAR"})
    EXPECT_EQ(meant(word), "linear");
}

TEST(Words, NearestForgivesAThirdOfTheWordAndAlwaysOneEdit) {
  EXPECT_EQ(meant("lonczas"), "lanczos");
  EXPECT_EQ(meant("xxnczas"), "");
  EXPECT_EQ(meant("ix"), "in");
  EXPECT_EQ(meant("xy"), "");
}

TEST(Words, TheFirstOfEqualsWins) {
  EXPECT_EQ(meant("an"), "in");
}

TEST(Words, NearestFindsCommandsAndOptionsAndNothingFar) {
  const std::vector<std::string> names = {"morph", "map", "compare", "--overwrite"};
  EXPECT_EQ(nearest("morhp", names), "morph");
  EXPECT_EQ(nearest("mrph", names), "morph");
  EXPECT_EQ(nearest("comparee", names), "compare");
  EXPECT_EQ(nearest("--overwritte", names), "--overwrite");
  EXPECT_EQ(nearest("render", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest("morph", std::vector<std::string>()), std::nullopt);
}

}  // namespace
}  // namespace morphkit::test
