// The tree: what lies flat, what that costs, and that flat or not makes no difference to readers and writers.

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/json/cursor.h"
#include "morph/json/json.h"

namespace {

std::atomic<std::size_t> live_bytes = 0, peak_bytes = 0;

void* counted(std::size_t size) {
  void* const memory = std::malloc(size);
  if (!memory) throw std::bad_alloc();
  live_bytes += malloc_usable_size(memory);
  peak_bytes = std::max(peak_bytes.load(), live_bytes.load());
  return memory;
}

void release(void* memory) noexcept {
  if (memory) live_bytes -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

// What the tests of this program allocate is counted.
void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete[](void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  release(memory);
}

namespace morphkit::test {
namespace {

using json::Node;

Node parsed(const std::string& text) {
  return json::parse(text, "tree.json");
}

/// "[item,item,...]"
std::string list_of(std::size_t count, const std::string& item) {
  std::string text = "[" + item;
  for (std::size_t i = 1; i < count; ++i) text.append(",").append(item);
  return text + "]";
}

/// The bytes that parsing takes at most, beside the text.
std::size_t peak_of(const std::string& text) {
  const std::size_t before = live_bytes;
  peak_bytes = before;
  parsed(text);
  return peak_bytes - before;
}

TEST(Node, NumbersAndRowsOfNumbersLieFlat) {
  EXPECT_TRUE(parsed("[]").is_flat());
  EXPECT_EQ(parsed("[1, 2.5, -3]").flat(), (json::Flat{{1, 2.5, -3}, 0}));
  EXPECT_EQ(parsed("[[1, 2], [3, 4]]").flat(), (json::Flat{{1, 2, 3, 4}, 2}));
  EXPECT_EQ(parsed("[[1], [2]]").flat(), (json::Flat{{1, 2}, 1}));
}

TEST(Node, WhatIsMixedHasANodePerItem) {
  for (const char* text : {"[1, \"a\"]", "[[1, 2], [3]]", "[[1, 2], 3]", "[1, [2, 3]]", "[[]]", "[[], [1]]",
                           "[[1], []]", "[[[1]], [[2]]]", "[null]", "[true]", "[{}]"}) {
    const Node node = parsed(text);
    EXPECT_FALSE(node.is_flat()) << text;
    EXPECT_EQ(node.size(), node.items().size()) << text;
    EXPECT_EQ(parsed(json::write(node, "")).is_flat(), false) << text;
    EXPECT_TRUE(json::same_value(parsed(json::write(node, "")), node)) << text;
  }
}

TEST(Node, FlatAndTakenApartAreTheSameValue) {
  for (const char* text : {"[]", "[1, 2]", "[[1, 2], [3, 4]]"}) {
    const Node flat = parsed(text);
    Node apart = flat;
    apart.mutable_items();
    EXPECT_FALSE(apart.is_flat());
    EXPECT_EQ(apart.size(), flat.size());
    EXPECT_TRUE(json::same_value(flat, apart)) << text;
    EXPECT_TRUE(json::same_value(apart, flat)) << text;
    EXPECT_EQ(json::write(apart, ""), json::write(flat, "")) << text;
  }
  EXPECT_FALSE(json::same_value(parsed("[1, 2, 3, 4]"), parsed("[[1, 2], [3, 4]]")));
  EXPECT_FALSE(json::same_value(parsed("[[1, 2], [3, 4]]"), parsed("[[1, 2], [3, 5]]")));
}

TEST(Node, CursorsReadFlatArraysAsAnyOther) {
  const json::Document document{"f", parsed(R"({"a": [[1, 2], [3, 4]], "b": [5, 6]})")};
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
  try {
    row.fail_expected("a word");
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "f: /a/1: expected a word, found an array of 2");
  }
}

TEST(Node, PlacesOfItemsAreFoundWhenTheyAreNeeded) {
  const std::string text = "{ \"a\" : [ [1, 2],\n [ 3.50 ,4] ] }";
  Node root = parsed(text);
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

TEST(Node, AMeshCostsFewBytesPerNumber) {
  constexpr std::size_t kRows = 100'000;
  const std::string text = list_of(kRows, "[1.25,2.5]");
  // Eight, and as much again where the block has just grown.
  EXPECT_LT(peak_of(text), 2 * kRows * 8 * 3 + 10'000);
}

TEST(Node, HostileTextsAreBounded) {
  constexpr std::size_t kCount = 50'000, kMostPerValue = 160;
  struct Item {
    const char* text;
    std::size_t values;
  };
  for (const Item& item :
       {Item{"null", 1}, {"[]", 1}, {"{}", 1}, {"\"\"", 1}, {"[\"\"]", 2}, {"[[0]]", 3}, {"{\"\":0}", 2}}) {
    EXPECT_LT(peak_of(list_of(kCount, item.text)), kCount * item.values * kMostPerValue) << item.text;
  }
}

}  // namespace
}  // namespace morphkit::test
