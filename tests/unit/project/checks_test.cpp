#include "morph/project/checks.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::Bad;
using test::expect_bad;
using test::with;
using test::with_feature;
using test::with_line;
using test::with_mesh;

TEST(Checks, WhatDoesNotFitTogetherNamesThePlace) {
  const std::string line = R"({"id": "x", "line": {"source": [[0, 0], [1, 0]], "destination": [[0, 0], [2, 0]]}})";
  const std::string square = "[[0, 0], [9, 0], [9, 9], [0, 0]]", open = "[[0, 0], [9, 0], [9, 9], [0, 1]]";
  const auto curve = [](const std::string& a, const std::string& b, const std::string& more) {
    return with_feature(R"({"id": "x", "curve": {"source": )" + a + R"(, "destination": )" + b + more + "}}");
  };
  const Bad table[] = {
      {with_feature(line + "," + line), "/features/1/id", "\"x\" occurs twice"},
      {with(R"("groups": [{"id": "g"}, {"id": "g"}])"), "/groups/1/id", "\"g\" occurs twice"},
      {with(
           R"("groups": [{"id": "face"}], "features": [{"id": "x", "group": "faec", "point": {"source": [0, 0], "destination": [0, 0]}}])"),
       "/features/0/group", "did you mean \"face\"?"},
      {with_line(R"("group": "face")"), "/features/0/group", "add it to \"groups\""},
      {with_feature(R"({"id": "x", "line": {"source": [[1, 1], [1, 1]], "destination": [[0, 0], [1, 1]]}})"),
       "/features/0/line/source", "on this side only"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1, 1]], "destination": [[1, 1], [1, 1]]}})"),
       "/features/0/line/destination", "on this side only"},
      {curve(square, open, ""), "/features/0/curve/source", "ends where it starts on this side only"},
      {curve(open, square, ""), "/features/0/curve/destination", "ends where it starts on this side only"},
      {curve(open, "[[0, 0], [1, 1], [2, 2]]", R"(, "spline": "bezier")"), "/features/0/curve/destination", "3n + 1"},
      {curve(open, "[[5, 5], [5, 5]]", ""), "/features/0/curve/destination", "coincide"},
      {with(R"("warp": {"method": "mesh"})"), "/warp/method", "needs a mesh; add \"mesh\": {\"size\""},
      {with(R"("mesh": {"size": [2, 2]}, "warp": {"border": "mirror"})"), "/warp/border", "cannot mirror"},
      {with(R"("features": [)" + line +
            R"(], "mesh": {"size": [2, 2]}, "warp": {"method": "mesh", "border": "mirror"})"),
       "/warp/border", "expected the border \"auto\""},
      {with_mesh(R"("size": [3, 2], "groups": [{"group": "g", "vertices": [[0, 1], [2, 2]]}])"),
       "/mesh/groups/0/vertices/1/1", "0 to 1"},
      {with_mesh(R"("size": [3, 2], "groups": [{"group": "g", "vertices": [[3, 0]]}])"), "/mesh/groups/0/vertices/0/0",
       "0 to 2"},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "gg", "vertices": []}])"), "/mesh/groups/0/group",
       "no group has the id \"gg\"; add it to \"groups\""},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "g", "vertices": []}, {"group": "g", "vertices": []}])"),
       "/mesh/groups/1/group", "list them all together"},
      {with_mesh(
           R"("size": [2, 2], "groups": [{"group": "g", "vertices": [[1, 0]]}, {"group": "h", "vertices": [[0, 0], [1, 0]]}])"),
       "/mesh/groups/1/vertices/1", "[1, 0] is in the group \"g\" already"},
  };
  for (const Bad& bad : table) expect_bad(bad);
}

}  // namespace
}  // namespace morphkit::project
