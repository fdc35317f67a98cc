// The tree: what lies flat, what that costs, and that flat or not makes no difference.

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>

#include <gtest/gtest.h>

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
