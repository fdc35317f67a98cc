#pragma once
// Documents that the loader and the schema must agree on, and shorthands to write them.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/project.h"

namespace morphkit::test {

inline constexpr const char* kSides = R"("source": {"image": "a.png"}, "destination": {"image": "b.png"})";

/// A smallest document with `more` keys.
inline std::string with(const std::string& more) {
  return std::string(R"({"morphkit": 1, )") + kSides + (more.empty() ? "" : ", ") + more + "}";
}
inline std::string with_feature(const std::string& feature) {
  return with(R"("features": [)" + feature + "]");
}
/// A line with id "x" and `more` keys.
inline std::string with_line(const std::string& more) {
  return with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1, 0]], "destination": [[0, 0], [2, 0]]}, )" + more +
                      "}");
}
inline std::string with_shape(const std::string& timing) {
  return with(R"("transition": {"shape": )" + timing + "}");
}
inline std::string with_output(const std::string& output) {
  return with(R"("output": {)" + output + "}");
}

inline std::string with_mesh(const std::string& mesh) {
  return with(R"("groups": [{"id": "g"}, {"id": "h"}], "mesh": {)" + mesh + "}");
}

/// Everything at once, laid out by hand.
inline constexpr const char* kFull = R"({
  "morphkit": 1,
  "source":      {"image": "cat.png", "colorspace": "srgb"},
  "destination": {"image": "tiger.png"},
  "groups": [
    {"id": "face", "warp": {"b": 1.50}, "transition": {"shape": "ease-in-out"}}
  ],
  "features": [
    {"id": "left eye", "group": "face", "line": {"source": [[310, 220], [365, 218]], "destination": [[402, 198.0], [470, 201]]}},
    {"id": "nose", "point": {"source": [340, 300], "destination": [436, 296]}, "warp": {"a": 1e1}},
    {"id": "chin", "group": "face",
     "curve": {"source": [[1, 2], [30, 4], [50, 60]],
               "destination": [[1, 2], [30, 4], [50, 60], [70, 80]],
               "spline": "catmull-rom", "closed": false},
     "transition": {"dissolve": {"ease": "sine", "delay": 0.25, "duration": 0.5}}}
  ],
  "warp": {"method": "lines", "a": 1, "b": 2, "p": 0, "scale": "along", "between": "centre", "turns": -1,
           "field": "exact", "filter": "bicubic", "border": "auto"},
  "transition": {"blend": "linear", "dissolve": "linear",
                 "shape": {"ease": "keys", "keys": [[0, 0], [0.4, 0.9, 0.1], [1, 1]]}},
  "output": {"fps": "24", "frames": 48, "size": [1280, 720], "background": "#FFffFF"}
}
)";

/// A mesh among other things, laid out by hand.
inline constexpr const char* kMesh = R"({
  "morphkit": 1,
  "source": {"image": "cat.png"}, "destination": {"image": "tiger.png"},
  "groups": [{"id": "face", "transition": {"shape": "sine"}}, {"id": "rim"}],
  "mesh": {
    "size": [3, 2],
    "destination": "uniform",
    "source": [
      [0, 0],   [320.0, 0],   [640, 0],
      [0, 480], [300.5, 480], [640, 480]
    ],
    "groups": [
      {"group": "rim", "vertices": [[0, 0], [2, 1]]},
      {"vertices": [[1, 0]], "group": "face"}
    ]
  },
  "warp": {"method": "mesh", "spline": "monotone", "order": "rows-first"}
}
)";

inline std::vector<std::string> good_documents() {
  const std::string curve = R"({"id": "c", "curve": {"source": [[0, 0], [9, 0], [9, 9], [0, 9]], "destination": )"
                            R"([[1, 0], [9, 0], [9, 9], [0, 9]])";
  return {
      with(""),
      kFull,
      with(R"("features": [], "groups": [], "warp": {}, "transition": {}, "output": {})"),
      R"({"morphkit": 1.0, "source": {"image": "a", "colorspace": "linear"}, "destination": {"image": "b"}})",
      with_line(R"("warp": {}, "transition": {})"),
      with_line(R"("warp": {"a": 0, "b": 0, "p": 1, "scale": "uniform", "between": "endpoints", "turns": 3.0})"),
      with_feature(R"({"id": "p", "point": {"source": [-1e6, 1e6], "destination": [0.5, 0]}})"),
      with_feature(R"({"id": "dot", "line": {"source": [[1, 1], [1, 1]], "destination": [[2, 2], [2, 2]]}})"),
      with_feature(curve + "}}"),
      with_feature(curve + R"(, "spline": "polyline", "closed": true}})"),
      with_feature(curve + R"(, "spline": "bezier"}})"),
      with_shape(R"("linear")"),
      with_shape(R"("ease-in")"),
      with_shape(R"("step")"),
      with_shape("{}"),
      with_shape(R"({"delay": 0.3})"),
      with_shape(R"({"ease": "sinusoidal", "k1": 0, "k2": 1})"),
      with_shape(R"({"ease": "parabolic", "t1": 0.5, "delay": 0.1, "duration": 0.9})"),
      with_shape(R"({"ease": "cubic-bezier", "handles": [0.2, -1, 0.8, 2]})"),
      with_shape(R"({"ease": "cubic-bezier"})"),
      with_shape(R"({"ease": "ease-out", "duration": 0})"),
      with_shape(R"({"ease": "step", "at": 0.9})"),
      with_shape(R"({"ease": "keys", "keys": [[0, 0], [1, 1]]})"),
      with(R"("transition": {"blend": "display", "dissolve": "parabolic"})"),
      with(R"("warp": {"filter": "nearest", "border": "mirror"})"),
      kMesh,
      with_mesh(R"("size": [2, 1000])"),
      with_mesh(
          R"("size": [2, 2], "source": "uniform", "destination": [[0, 0], [9, 0], [0, 9], [9, 9]], "groups": [])"),
      with_mesh(R"("size": [3, 3], "groups": [{"group": "h", "vertices": [[2, 2]]}, {"group": "g", "vertices": []}])"),
      with(R"("mesh": {"size": [2, 2]}, "warp": {"method": "lines", "border": "mirror", "spline": "linear"})"),
      with(
          R"("mesh": {"size": [2, 2]}, "warp": {"method": "mesh", "spline": "catmull-rom", "order": "columns-first"})"),
      with_output(R"("size": [1, 65536], "fit": "none", "frames": 10000000, "start": 0)"),
      with_output(R"("fps": 29.97, "background": "transparent")"),
      with_output(R"("fps": "30000/1001", "background": "#20406080")"),
      with_output(R"("fps": "25", "background": [0, 0.5, 1])"),
      with_output(R"("fps": 1000, "background": {"image": "sky.png"})"),
  };
}

/// A document that is wrong in its structure, what the message must point at and what it must say.
struct Bad {
  std::string text;
  std::string pointer;
  std::string says;
};

/// Expects that the loader refuses the document with a message that points there and says that.
inline void expect_bad(const Bad& bad) {
  SCOPED_TRACE(bad.text.substr(0, 300));
  try {
    project::parse(bad.text, "dir/pair.json");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(error.place(), bad.pointer.empty() ? "dir/pair.json" : "dir/pair.json: " + bad.pointer);
    EXPECT_NE(error.message().find(bad.says), std::string::npos) << error.message();
  }
}

/// Both the loader and the schema refuse these.
inline std::vector<Bad> structurally_bad_documents() {
  const std::string f0 = "/features/0";
  return {
      {"[]", "", "expected an object"},
      {"{}", "", "\"morphkit\" is missing"},
      {R"({"morphkit": 2, "new": {}})", "/morphkit", "version 2 is newer than this program"},
      {R"({"morphkit": 0})", "/morphkit", "no version 0"},
      {R"({"morphkit": "1"})", "/morphkit", "expected the version"},
      {R"({"morphkit": 1, "destination": {"image": "b"}})", "", "\"source\" is missing"},
      {R"({"morphkit": 1, "source": {"image": "a"}})", "", "\"destination\" is missing"},
      {R"({"morphkit": 1, "source": {}, "destination": {"image": "b"}})", "/source", "\"image\" is missing"},
      {R"({"morphkit": 1, "source": "a", "destination": {"image": "b"}})", "/source", "expected an object"},
      {R"({"morphkit": 1, "source": {"image": ""}, "destination": {"image": "b"}})", "/source/image", "empty"},
      {R"({"morphkit": 1, "source": {"image": 3}, "destination": {"image": "b"}})", "/source/image", "a string, found"},
      {R"({"morphkit": 1, "source": {"image": "a", "colorspace": "sRGB"}, "destination": {"image": "b"}})",
       "/source/colorspace", "did you mean \"srgb\"?"},
      {with(R"("feature": [])"), "/feature", "did you mean \"features\"?"},
      {with(R"("zzzzzz": 1)"), "/zzzzzz", "expected one of"},
      {with(R"("features": {})"), "/features", "expected an array"},
      {with(R"("features": null)"), "/features", "found null"},
      {with_feature("3"), f0, "expected an object, found the number 3"},
      {with_feature(R"({"point": {"source": [0, 0], "destination": [0, 0]}})"), f0, "\"id\" is missing"},
      {with_feature(R"({"id": "", "point": {"source": [0, 0], "destination": [0, 0]}})"), f0 + "/id", "empty"},
      {with_feature(R"({"id": 7, "point": {"source": [0, 0], "destination": [0, 0]}})"), f0 + "/id", "a string"},
      {with_feature(R"({"id": "x"})"), f0, "exactly one of"},
      {with_feature(
           R"({"id": "x", "point": {"source": [0, 0], "destination": [0, 0]}, "line": {"source": [[0, 0], [1, 1]], "destination": [[0, 0], [1, 1]]}})"),
       f0, "exactly one of"},
      {with_line(R"("lien": 1)"), f0 + "/lien", "did you mean \"line\"?"},
      {with_line(R"("group": "")"), f0 + "/group", "empty"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1, 1]]}})"), f0 + "/line", "both sides"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0]], "destination": [[0, 0], [1, 1]]}})"),
       f0 + "/line/source", "the two ends"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1]], "destination": [[0, 0], [1, 1]]}})"),
       f0 + "/line/source/1", "a point [x, y]"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1, "2"]], "destination": [[0, 0], [1, 1]]}})"),
       f0 + "/line/source/1/1", "expected a number, found the string \"2\""},
      {with_feature(R"({"id": "x", "point": {"source": [0, 1e300], "destination": [0, 0]}})"), f0 + "/point/source/1",
       "out of range"},
      {with_feature(R"({"id": "x", "point": {"source": [0, null], "destination": [0, 0]}})"), f0 + "/point/source/1",
       "found null"},
      {with_feature(R"({"id": "x", "point": {"source": [0, 0, 0], "destination": [0, 0]}})"), f0 + "/point/source",
       "a point"},
      {with_feature(R"({"id": "x", "curve": {"source": [[0, 0]], "destination": [[0, 0], [1, 1]]}})"),
       f0 + "/curve/source", "2 to 100000 points"},
      {with_feature(
           R"({"id": "x", "curve": {"source": [[0, 0], [1, 1]], "destination": [[0, 0], [1, 1]], "spline": "bezeir"}})"),
       f0 + "/curve/spline", "did you mean \"bezier\"?"},
      {with_feature(
           R"({"id": "x", "curve": {"source": [[0, 0], [1, 1]], "destination": [[0, 0], [1, 1]], "closed": 0}})"),
       f0 + "/curve/closed", "true or false"},
      {with_line(R"("warp": {"filter": "nearest"})"), f0 + "/warp/filter", "unknown key"},
      {with_line(R"("warp": 1)"), f0 + "/warp", "expected an object"},
      {with_line(R"("transition": {"blend": "linear"})"), f0 + "/transition/blend", "unknown key"},
      {with(R"("groups": [{}])"), "/groups/0", "\"id\" is missing"},
      {with(R"("groups": [{"id": "g", "warp": {"a": -1}}])"), "/groups/0/warp/a", "expected 0 to 1000000"},
      {with(R"("warp": {"method": "fields"})"), "/warp/method", "expected one of \"lines\", \"mesh\""},
      {with(R"("warp": {"spline": "cubic"})"), "/warp/spline", "expected one of"},
      {with(R"("warp": {"order": "row-first"})"), "/warp/order", "did you mean \"rows-first\"?"},
      {with_line(R"("warp": {"spline": "linear"})"), f0 + "/warp/spline", "unknown key"},
      {with(R"("mesh": [])"), "/mesh", "expected an object"},
      {with_mesh(""), "/mesh", "\"size\" is missing"},
      {with_mesh(R"("size": 4)"), "/mesh/size", "[columns, rows]"},
      {with_mesh(R"("size": [4, 1])"), "/mesh/size/1", "2 to 1000"},
      {with_mesh(R"("size": [1001, 4])"), "/mesh/size/0", "2 to 1000"},
      {with_mesh(R"("size": [4, 2.5])"), "/mesh/size/1", "a whole number"},
      {with_mesh(R"("size": [2, 2], "vertices": [])"), "/mesh/vertices", "unknown key"},
      {with_mesh(R"("size": [2, 2], "source": "even")"), "/mesh/source", "or \"uniform\", found the string \"even\""},
      {with_mesh(R"("size": [2, 2], "destination": {})"), "/mesh/destination", "expected 4 vertices"},
      {with_mesh(R"("size": [2, 2], "source": [[0, 0], [9, 0], [0, 9]])"), "/mesh/source",
       "expected 4 vertices [x, y] (2 columns x 2 rows, row by row), found an array of 3"},
      {with_mesh(R"("size": [2, 2], "source": [[0, 0], [9, 0], [0, 9], [9]])"), "/mesh/source/3", "a point [x, y]"},
      {with_mesh(R"("size": [2, 2], "source": [[0, 0], [9, 0], [0, 9], [9, 1e7]])"), "/mesh/source/3/1",
       "-1000000 to 1000000"},
      {with_mesh(R"("size": [2, 2], "groups": {})"), "/mesh/groups", "an array of at most"},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "g"}])"), "/mesh/groups/0", "\"vertices\" is missing"},
      {with_mesh(R"("size": [2, 2], "groups": [{"vertices": []}])"), "/mesh/groups/0", "\"group\" is missing"},
      {with_mesh(R"("size": [2, 2], "groups": [{"id": "g", "vertices": []}])"), "/mesh/groups/0/id", "unknown key"},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "g", "vertices": [0, 1]}])"), "/mesh/groups/0/vertices/0",
       "a vertex [column, row]"},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "g", "vertices": [[0, -1]]}])"), "/mesh/groups/0/vertices/0/1",
       "0 to 1"},
      {with(R"("warp": {"b": 8.5})"), "/warp/b", "expected 0 to 8"},
      {with(R"("warp": {"p": 2})"), "/warp/p", "expected 0 to 1"},
      {with(R"("warp": {"turns": 0.5})"), "/warp/turns", "a whole number"},
      {with(R"("warp": {"between": "center"})"), "/warp/between", "did you mean \"centre\"?"},
      {with(R"("warp": {"scale": "both"})"), "/warp/scale", "expected one of \"along\", \"uniform\""},
      {with(R"("warp": {"filter": "gauss"})"), "/warp/filter", "expected one of"},
      {with(R"("warp": {"border": "repeat"})"), "/warp/border", "expected one of"},
      {with_shape(R"("easy")"), "/transition/shape", "did you mean \"ease\"?"},
      {with_shape("3"), "/transition/shape", "the name of an easing"},
      {with_shape(R"("keys")"), "/transition/shape", "wants its keys"},
      {with_shape(R"({"ease": "keys"})"), "/transition/shape", "wants its keys"},
      {with_shape(R"({"ease": "keys", "keys": [[0, 0]]})"), "/transition/shape/keys", "an array of 2 to"},
      {with_shape(R"({"ease": "keys", "keys": [[0, 0], [1]]})"), "/transition/shape/keys/1", "a key [time, progress]"},
      {with_shape(R"({"ease": "linear", "at": 0.5})"), "/transition/shape/at", "unknown key"},
      {with_shape(R"({"ease": "ease-in", "handles": [0, 0, 1, 1]})"), "/transition/shape/handles", "unknown key"},
      {with_shape(R"({"ease": "cubic-bezier", "handles": [2, 0, 1, 1]})"), "/transition/shape/handles/0", "0 to 1"},
      {with_shape(R"({"ease": "cubic-bezier", "handles": [0, 0, 1]})"), "/transition/shape/handles", "four numbers"},
      {with_shape(R"({"ease": "sinusoidal", "k1": -1})"), "/transition/shape/k1", "0 to 1"},
      {with_shape(R"({"ease": "step", "at": 2})"), "/transition/shape/at", "0 to 1"},
      {with_shape(R"({"delay": -0.5})"), "/transition/shape/delay", "0 to 1"},
      {with_shape(R"({"duration": 1.5})"), "/transition/shape/duration", "0 to 1"},
      {with(R"("transition": {"blend": "gamma"})"), "/transition/blend", "expected one of"},
      {with_output(R"("size": [0, 5])"), "/output/size/0", "1 to 65536"},
      {with_output(R"("size": [65537, 5])"), "/output/size/0", "1 to 65536"},
      {with_output(R"("size": [1.5, 5])"), "/output/size/0", "a whole number"},
      {with_output(R"("size": 100)"), "/output/size", "[width, height]"},
      {with_output(R"("fit": "fill")"), "/output/fit", "expected one of"},
      {with_output(R"("frames": 0)"), "/output/frames", "1 to 10000000"},
      {with_output(R"("frames": 10000001)"), "/output/frames", "1 to 10000000"},
      {with_output(R"("frames": "48")"), "/output/frames", "a number, found the string"},
      {with_output(R"("start": -1)"), "/output/start", "0 to"},
      {with_output(R"("fps": 0)"), "/output/fps", "1 to 1000"},
      {with_output(R"("fps": 12.5)"), "/output/fps", "25/2"},
      {with_output(R"("fps": "24 fps")"), "/output/fps", "a frame rate such as"},
      {with_output(R"("fps": [24, 1])"), "/output/fps", "a frame rate such as"},
      {with_output(R"("background": "#12345")"), "/output/background", "#rrggbb"},
      {with_output(R"("background": "red")"), "/output/background", "#rrggbb"},
      {with_output(R"("background": [0, 0, 2])"), "/output/background/2", "0 to 1"},
      {with_output(R"("background": [0, 0])"), "/output/background", "[r, g, b]"},
      {with_output(R"("background": {"file": "x"})"), "/output/background/file", "expected \"image\""},
      {with_output(R"("background": true)"), "/output/background", "a colour"},
  };
}

}  // namespace morphkit::test
