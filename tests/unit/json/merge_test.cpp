// A changed tree over its old text: what did not change keeps its spelling.

#include "morph/json/merge.h"

#include <string>

#include <gtest/gtest.h>

namespace morphkit::test {
namespace {

/// The text of `full` and `minimal` laid over `original`. Items of "list" are known by "id".
std::string merged(const std::string& original, const std::string& full_text, const std::string& minimal_text) {
  json::Document document{"f", json::parse(original, "f")};
  json::locate(document.root, original);
  json::Node full = json::parse(full_text, "f"), minimal = json::parse(minimal_text, "f");
  for (json::Node* root : {&full, &minimal})
    if (json::Node* list = root->find("list")) list->mutable_hints().identity = "id";
  return json::write(json::merge(document, original, full, minimal), original);
}

TEST(Merge, WhatIsEqualKeepsItsText) {
  const std::string text = "{ \"b\" : 1.50,\n\t\"a\":[ [1,2] , [3.0,4] ] }\n";
  EXPECT_EQ(merged(text, R"({"a": [[1, 2], [3, 4]], "b": 1.5})", "{}"), text);
}

TEST(Merge, OneNumberOfARowChangesAlone) {
  EXPECT_EQ(merged("{\"a\":[ [1.0,2] , [3.0,4] ]}", R"({"a": [[1, 2], [3, 5]]})", R"({"a": [[1, 2], [3, 5]]})"),
            "{\"a\":[ [1.0,2] , [3.0,5] ]}");
}

TEST(Merge, NewItemsAreSpacedAsTheOldOnes) {
  EXPECT_EQ(merged("{\"a\":[ 1.0 ,  2 ]}", R"({"a": [1, 2, 3]})", R"({"a": [1, 2, 3]})"), "{\"a\":[ 1.0 ,  2 ,  3 ]}");
}

TEST(Merge, KeysComeAndGo) {
  EXPECT_EQ(merged(R"({"old": 1, "b": 2})", R"({"a": 7, "b": 2, "c": 0})", R"({"a": 7, "b": 2})"),
            "{\"a\": 7, \"b\": 2}\n");
}

TEST(Merge, ItemsOfAListFollowTheirId) {
  const std::string wanted = R"({"list": [{"id": "y", "n": 2}, {"id": "x", "n": 1}]})";
  EXPECT_EQ(merged(R"({"list": [{"id":"x","n":1.0}, {"id":"y","n":2.0}]})", wanted, wanted),
            R"({"list": [{"id":"y","n":2.0}, {"id":"x","n":1.0}]})");
}

}  // namespace
}  // namespace morphkit::test
