#include "morph/json/cursor.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/errors.h"

namespace morphkit::test {
namespace {

/// The message that reading `text` in this way ends with.
template <typename Read>
std::string message(const std::string& text, const Read& read) {
  const json::Document document{"f", json::parse(text, "f")};
  return error_of([&] { read(json::Cursor(document)); }).what();
}

TEST(Cursor, ReadsFlatArraysAsAnyOther) {
  const json::Document document{"f", json::parse(R"({"a": [[1, 2], [3, 4]], "b": [5, 6]})", "f")};
  const json::Cursor rows = *json::Cursor(document).find("a"), row = rows.item(1), number = row.item(0);
  EXPECT_TRUE(row.is(json::Kind::kArray));
  EXPECT_EQ(row.size(), 2U);
  EXPECT_EQ(row.pointer(), "/a/1");
  EXPECT_EQ(number.number(0, 9), 3);
  EXPECT_EQ(number.pointer(), "/a/1/0");
  EXPECT_FALSE(row.find("a"));
  const json::Cursor six = json::Cursor(document).find("b")->item(1);
  EXPECT_EQ(six.integer(0, 9), 6);
  EXPECT_EQ(six.pointer(), "/b/1");
  EXPECT_STREQ(error_of([&] { row.fail_expected("a word"); }).what(), "f: /a/1: expected a word, found an array of 2");
}

TEST(Cursor, NamesThePlaceWhatIsWrongAndWhatWouldBeRight) {
  EXPECT_EQ(
      message(R"({"a/b": [{"c": "x"}]})", [](const json::Cursor& at) { at.find("a/b")->item(0).find("c")->number(); }),
      "f: /a~1b/0/c: expected a number, found the string \"x\"");
  EXPECT_EQ(message("[3]", [](const json::Cursor& at) { at.item(0).number(0, 2); }),
            "f: /0: 3 is out of range; expected 0 to 2");
  EXPECT_EQ(message("[0.5]", [](const json::Cursor& at) { at.item(0).integer(0, 2); }),
            "f: /0: expected a whole number, found the number 0.5");
  EXPECT_EQ(message("1", [](const json::Cursor& at) { at.boolean(); }),
            "f: expected true or false, found the number 1");
  EXPECT_EQ(message("[1]", [](const json::Cursor& at) { at.expect_array(2, 3, "two or three"); }),
            "f: expected two or three, found an array of 1");
  EXPECT_EQ(message("{}", [](const json::Cursor& at) { at.require("id", "give one"); }),
            "f: \"id\" is missing: give one");
}

TEST(Cursor, KeysAndWordsHaveANearestOne) {
  const std::string_view keys[] = {"size", "frames"};
  EXPECT_EQ(message(R"({"frame": 1})", [&](const json::Cursor& at) { at.allow_keys(keys); }),
            "f: /frame: unknown key \"frame\"; did you mean \"frames\"?");
  const std::pair<std::string_view, int> words[] = {{"one", 1}, {"two", 2}};
  EXPECT_EQ(message("\"twenty\"", [&](const json::Cursor& at) { at.choice<int>("count", words); }),
            "f: unknown count \"twenty\"; expected one of \"one\", \"two\"");
}

TEST(Cursor, NamesAreNotEmptyAndHaveNoControlCharacters) {
  const auto name = [](const json::Cursor& at) { static_cast<void>(at.name("the id")); };
  EXPECT_EQ(message("\"\"", name), "f: the id must not be empty");
  EXPECT_EQ(message(R"("a\nb")", name), "f: the id holds a control character; remove it");
}

TEST(Cursor, PathsAreNotEmptyAndHaveNoNul) {
  const auto path = [](const json::Cursor& at) { static_cast<void>(at.path("the path")); };
  EXPECT_EQ(message("\"\"", path), "f: the path must not be empty");
  EXPECT_EQ(message(R"("a\u0000b")", path), "f: the path holds a NUL character; remove it");
  const json::Document document{"f", json::parse(R"("a\u0001b")", "f")};
  EXPECT_EQ(json::Cursor(document).path("the path"), "a\001b");
}

}  // namespace
}  // namespace morphkit::test
