// Text from trees, and the places of values in their text.

#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "morph/json/json.h"
#include "tests/support/errors.h"

namespace morphkit::test {
namespace {

using json::Node;

std::string rewritten(const std::string& text) {
  return json::write(json::parse(text, "f"), "");
}

TEST(Write, ShortContainersStandOnOneLine) {
  EXPECT_EQ(rewritten(R"({ "a":[1,  [2,3]],"b":{},"c":[ ],"d":null,"e":true })"),
            "{\"a\": [1, [2, 3]], \"b\": {}, \"c\": [], \"d\": null, \"e\": true}\n");
}

TEST(Write, LongListsAreFilledLineByLine) {
  std::string text = "[[100, 200]";
  for (int i = 0; i < 20; ++i) text += ", [100, 200]";
  const std::string written = rewritten(text + "]");
  EXPECT_TRUE(written.starts_with("[\n  [100, 200], [100, 200]")) << written;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = written.find('\n', begin);
    EXPECT_LE(std::min(end, written.size()) - begin, 120U);
  }
}

TEST(Write, AsManyItemsOnALineAsAskedFor) {
  Node rows = json::parse("[[1, 2], [3, 4], [5, 6]]", "f");
  rows.mutable_hints().per_line = 2;
  EXPECT_EQ(json::write(rows, ""), "[\n  [1, 2], [3, 4],\n  [5, 6]\n]\n");
}

TEST(Write, WhatIsNotFreshIsCopied) {
  const std::string text = " {\"a\" :1.50 , \"b\": [ 1,2 ]}\n";
  Node root = json::parse(text, "f");
  json::locate(root, text);
  EXPECT_EQ(json::write(root, text), text);
  *root.find("a") = [&] {
    Node two = Node::of_number(2);
    two.begin = root.find("a")->begin;
    two.end = root.find("a")->end;
    return two;
  }();
  EXPECT_EQ(json::write(root, text), " {\"a\" :2 , \"b\": [ 1,2 ]}\n");
}

TEST(Locate, PlacesOfItemsAreFoundWhenTheyAreNeeded) {
  const std::string text = "{ \"a\" : [ [1, 2],\n [ 3.50 ,4] ] }";
  Node root = json::parse(text, "f");
  json::locate(root, text);
  Node& rows = *root.find("a");
  ASSERT_TRUE(rows.is_flat());
  EXPECT_EQ(text.substr(rows.begin, rows.end - rows.begin), "[ [1, 2],\n [ 3.50 ,4] ]");
  json::locate_items(rows, text);
  EXPECT_EQ(text.substr(rows.key_begin, 3), "\"a\"");
  Node& row = rows.mutable_items()[1];
  EXPECT_EQ(text.substr(row.begin, row.end - row.begin), "[ 3.50 ,4]");
  json::locate_items(row, text);
  const Node& number = row.items()[0];
  EXPECT_EQ(text.substr(number.begin, number.end - number.begin), "3.50");
  EXPECT_FALSE(number.fresh);
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(json::number_text(3), "3");
  EXPECT_EQ(json::number_text(-0.1), "-0.1");
  EXPECT_EQ(json::number_text(9007199254740992.0), "9007199254740992");
  EXPECT_THROW(json::number_text(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(Quote, EscapesWhatJsonWantsAndRefusesWhatIsNotUtf8) {
  EXPECT_EQ(json::quote("a\"\\\n\xC3\xA4"), "\"a\\\"\\\\\\u000a\xC3\xA4\"");
  for (const char* bad : {"\xFF", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82"}) {
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(json::quote(bad)); }).what(), "is not UTF-8"));
  }
}

}  // namespace
}  // namespace morphkit::test
