// Text to trees, and what is refused.

#include "morph/json/json.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/errors.h"

namespace morphkit::test {
namespace {

std::string message(const std::string& text) {
  return error_of([&] { json::parse(text, "f"); }).what();
}

TEST(Parse, KeepsValuesAndTheOrderOfKeys) {
  const json::Node root = json::parse(R"({"b": [true, null, "\u00e4"], "a": -1.5e3, "c": {}})", "f");
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_TRUE(root.find("b")->items()[0].boolean());
  EXPECT_TRUE(root.find("b")->items()[1].is(json::Kind::kNull));
  EXPECT_EQ(root.find("b")->items()[2].text(), "\xC3\xA4");
  EXPECT_EQ(root.find("a")->number(), -1500);
  EXPECT_EQ(root.find("c")->size(), 0U);
  EXPECT_FALSE(root.find("d"));
}

TEST(Parse, NamesTheValueThatItRefuses) {
  EXPECT_EQ(message(R"({"a": [[1, 2], [3, 1e999]]})"), "f: /a/1/1: the number \"1e999\" is too large");
  EXPECT_EQ(message(R"([[1], {"k": 1e999}])"), "f: /1/k: the number \"1e999\" is too large");
  EXPECT_EQ(message(R"({"a": [0, {"k": 1, "k": 2}]})"), "f: /a/1/k: the key \"k\" occurs twice here; remove one");
  EXPECT_TRUE(contains(message("[1, 2"), "f:1:6"));
}

TEST(Shown, IsShortAndWithoutControlCharacters) {
  EXPECT_EQ(json::shown("a\nb"), "\"a?b\"");
  EXPECT_EQ(json::shown(std::string(47, 'x') + "\xC3\xA4"), "\"" + std::string(47, 'x') + "...\"");
}

TEST(PointerToken, EscapesTildeAndSlash) {
  EXPECT_EQ(json::pointer_token("a/b~c"), "/a~1b~0c");
}

TEST(StripBom, TakesThatOfUtf8AndRefusesUtf16) {
  EXPECT_EQ(json::strip_bom("\xEF\xBB\xBF{}", "f"), "{}");
  EXPECT_TRUE(contains(error_of([] { json::strip_bom("\xFF\xFE{", "f"); }).what(), "UTF-16"));
}

}  // namespace
}  // namespace morphkit::test
