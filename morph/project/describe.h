#pragma once
// The form of the document: one line for each key. To add a key: the member, and a line here. Checks that look across
// keys are in checks.cpp. Internal to morph/project.

#include "morph/project/codecs.h"
#include "morph/project/form.h"
#include "morph/project/project.h"

namespace morphkit::project {

template <typename F>
void describe(F& form, Of<Pull>) {
  form("a", &Pull::a, {.least = 0, .most = kMaxCoordinate, .usual = 1},
       "softness of the pull near a feature, in pixels; at 0, pixels on the feature follow it exactly");
  form("b", &Pull::b, {.least = 0, .most = kMaxFalloff, .usual = 2},
       "how fast the pull of a feature falls with distance; 0.5 to 2 is usual");
  form("p", &Pull::p, {.least = 0, .most = 1, .usual = 0}, "how much more longer lines pull than shorter ones");
  form("scale", &Pull::scale, {},
       "when a line grows: `\"along\"` stretches the picture only along the line, `\"uniform\"` scales it in all "
       "directions");
  form("between", &Pull::between, {.what = "way between"},
       "the way of a line: with `\"endpoints\"` both ends move straight (a line that turns shrinks meanwhile); with "
       "`\"centre\"` the centre and the length change evenly while the line turns");
  form("turns", &Pull::turns, {.least = -kMaxTurns, .most = kMaxTurns, .whole = true},
       "extra turns on the way, clockwise on screen; only with `between` `centre`");
}

template <typename F>
void describe(F& form, Of<Pace>) {
  form("shape", &Pace::shape, {}, "how the features move from one place to the other");
  form("dissolve", &Pace::dissolve, {}, "how the colours change; the timing of a feature applies around it");
}

template <typename F>
void describe(F& form, Of<LinesMethod>) {
  form("field", &LinesMethod::field, {},
       "how the field of lines is evaluated: `\"adaptive\"` interpolates the pull of far lines, within 1/32 pixel of "
       "`\"exact\"`, which takes several times as long");
}

template <typename F>
void describe(F& form, Of<MeshMethod>) {
  form("spline", &MeshMethod::spline, {},
       "the curves through the vertices of the mesh: `\"monotone\"` (smooth, never beyond its vertices), "
       "`\"catmull-rom\"` (rounder; overshoots between uneven vertices) or `\"linear\"`");
  form("order", &MeshMethod::order, {},
       "the first pass of the mesh: `\"rows-first\"`, `\"columns-first\"`, or `\"auto\"`: the order without folds, or "
       "of two "
       "the one that keeps more of the picture");
}

template <typename F>
void describe(F& form, Of<Group>) {
  form("id", &Group::id, {.what = "an id", .needed = "give the group a name of its own", .identity = true},
       "a name of its own, unique among the groups");
  form("warp", &Group::pull, {}, "settings of `warp` for its features");
  form("transition", &Group::pace, {}, "settings of `transition` for its features and vertices");
}

constexpr std::string_view kBothSides = "a feature needs its place on both sides";
constexpr std::string_view kCurvePoints = "2 to 100000 points [[x, y], ...]";
static_assert(kMaxPoints == 100'000);

/// The place of a feature on both sides.
template <typename F>
void describe_places(F& form, const Facts& facts) {
  form(
      "source", [](auto& feature) -> auto& { return feature.places[kSource]; }, facts, "the place on the source");
  form(
      "destination", [](auto& feature) -> auto& { return feature.places[kDestination]; }, facts,
      "the place on the destination");
}

template <typename F>
void describe(F& form, Of<Feature>) {
  form("id", &Feature::id, {.what = "an id", .needed = "give the feature a name of its own", .identity = true},
       "a name of its own, unique among the features; messages and tools use it");
  form("group", &Feature::group, {.what = "a group", .otherwise = "none"}, "the id of a group whose settings apply");
  form.alternative(Of<Line>{}, "line", &Feature::mark, "A directed line on each side.", [](auto& line) {
    describe_places(line,
                    {.least = 2, .most = 2, .what = "the two ends of a line [[x, y], [x, y]]", .needed = kBothSides});
  });
  form.alternative(Of<Point>{}, "point", &Feature::mark, "A point on each side.",
                   [](auto& point) { describe_places(point, {.least = 1, .most = 1, .needed = kBothSides}); });
  form.alternative(
      Of<Curve>{}, "curve", &Feature::mark, "A curve on each side, matched by arc length.", [](auto& curve) {
        describe_places(curve, {.least = 2, .most = kMaxPoints, .what = kCurvePoints, .needed = kBothSides});
        curve(
            "spline", [](auto& feature) -> auto& { return std::get<Curve>(feature.mark).kind; }, {},
            "`\"polyline\"`: straight between the points; `\"catmull-rom\"`: smooth through all points; `\"bezier\"`: "
            "cubic pieces, 3n + 1 points (3n when closed); every third point lies on the curve");
        curve(
            "closed", [](auto& feature) -> auto& { return std::get<Curve>(feature.mark).closed; }, {},
            "`true` joins the last point to the first (from 3 points)");
      });
  form("warp", &Feature::pull, {}, "settings of `warp` for this feature");
  form("transition", &Feature::pace, {}, "settings of `transition` for this feature");
}

template <typename F>
void describe(F& form, Of<MeshGroup>) {
  form("group", &MeshGroup::group,
       {.what = "a group", .needed = "the id of the group that times these vertices", .identity = true},
       "the id of a group, whose `transition` times the vertices; a group stands here once");
  form("vertices", &MeshGroup::vertices, {.needed = "the vertices in this group, [[column, row], ...]"},
       "`[[column, row], ...]`, counted from 0; a vertex is in one group at most");
}

template <typename F>
void describe(F& form, Of<Mesh>) {
  constexpr auto kSelf = [](auto& mesh) -> auto& {
    return mesh;
  };
  form.as(GridCodec{}, "size", kSelf, {.needed = "the number of vertices, [columns, rows]"},
          "`[columns, rows]`: vertices in a row and vertices in a column, each 2 to 1000, together at most 500000");
  form.as(VerticesCodec<kSource>{}, "source", kSelf, {.otherwise = "`uniform`"},
          "the vertices on the source picture, in its pixels: `[[x, y], ...]`, as many as `size` says, row by row from "
          "the top, each row from the left; or `\"uniform\"`: evenly spaced over the picture");
  form.as(VerticesCodec<kDestination>{}, "destination", kSelf, {.otherwise = "`uniform`"},
          "the same vertices on the destination picture");
  form("groups", &Mesh::groups, {.what = "groups of vertices"}, "vertices that are timed with a group");
}

template <typename F>
void describe(F& form, Of<Picture>) {
  static constexpr std::string_view kSpaces[] = {"srgb", "linear"};
  form("image", &Picture::image,
       {.what = "the path of an image", .needed = "name a picture, e.g. {\"image\": \"cat.png\"}"},
       "path of the picture; relative paths start at the folder of the project file");
  form("colorspace", &Picture::colorspace,
       {.what = "colour space",
        .otherwise = "the tag in the picture; without a tag, `srgb` for 8 and 16 bits, `linear` for float",
        .words = kSpaces},
       "colour space of the values in the picture: `\"srgb\"` or `\"linear\"`");
}

template <typename F>
void describe(F& form, Of<Output>) {
  form("size", &Output::size, {.otherwise = "the size of the source picture"},
       "`[width, height]` in pixels, each 1 to 65536, together at most 2^30 pixels");
  form("fit", &Output::fit, {},
       "how a picture of another size is placed: `\"contain\"` (all of it is visible), `\"cover\"` (it fills the "
       "canvas), "
       "`\"stretch\"` (it fills the canvas and loses its proportions), `\"none\"` (pixel for pixel)");
  form("frames", &Output::frames, {.least = 1, .most = kMaxFrames}, "number of frames");
  form("start", &Output::start, {.least = 0, .most = kMaxStart}, "number of the first frame");
  form("fps", &Output::fps, {},
       "frames per second, up to 1000: a whole number, a fraction like `\"30000/1001\"`, or one of `23.976`, "
       "`23.98`, `29.97`, `47.952`, `59.94`, `119.88`, which mean the exact rates of video (24000/1001, 30000/1001, "
       "...)");
  form("background", &Output::background, {},
       "the background: a colour as on screen, `\"#rrggbb\"`, `\"#rrggbbaa\"`, `[r, g, b]` or `[r, g, b, a]` from 0 "
       "to 1, `\"transparent\"`, `\"black\"`, `\"white\"`; or a picture, `{\"image\": \"sky.png\"}`");
}

/// "warp" of the project: what features and groups may set too, and what only the project may.
template <typename F>
void describe_warp(F& form) {
  form(
      "method", [](auto& project) -> auto& { return project.warp.method; },
      {.otherwise =
           "`mesh` if there is a mesh and no feature, else `lines`. With features the mesh is not used by default; "
           "`morph` and `check` then say so"},
      "`\"lines\"`: feature lines after Beier and Neely, 1992; `\"mesh\"`: the mesh, in two passes, after Smythe, "
      "1990");
  form.part([](auto& project) -> auto& { return project.warp.template of<MeshMethod>(); });
  form.part(&Project::pull);
  form.part([](auto& project) -> auto& { return project.warp.template of<LinesMethod>(); });
  form(
      "filter", [](auto& project) -> auto& { return project.warp.filter; }, {},
      "sampling filter. `\"area\"`, `\"mitchell\"` (softer) and `\"lanczos\"` (sharper, rings at hard edges) average "
      "where "
      "the picture shrinks and are bicubic elsewhere; `\"nearest\"`, `\"bilinear\"` and `\"bicubic\"` always read a "
      "point");
  form(
      "border", [](auto& project) -> auto& { return project.warp.border; }, {},
      "colours beyond the edge of a picture: `\"transparent\"`, `\"clamp\"` (the edge continues), `\"mirror\"`, or "
      "`\"auto\"`: clamp if the picture covers the canvas, else transparent. With a mesh, `\"auto\"` clamps only if "
      "both "
      "pictures cover the canvas, because the outline moves from one to the other. The mesh does not support "
      "`\"mirror\"`");
}

template <typename F>
void describe(F& form, Of<Project>) {
  form.as(
      VersionCodec{}, "morphkit", [](auto& project) -> auto& { return project; },
      {.needed = "the version of the file's form, \"morphkit\": 1"}, "the version of the file's form, always 1");
  form(
      "source", [](auto& project) -> auto& { return project.pictures[kSource]; },
      {.needed = "the picture to start from, {\"image\": \"cat.png\"}"}, "The picture to start from.");
  form(
      "destination", [](auto& project) -> auto& { return project.pictures[kDestination]; },
      {.needed = "the picture to arrive at, {\"image\": \"tiger.png\"}"}, "The picture to arrive at.");
  form("groups", &Project::groups, {}, "Settings shared by features that name the group.");
  form("features", &Project::features, {}, "What corresponds to what.");
  form("mesh", &Project::mesh, {.otherwise = "none", .expand = true},
       "A grid laid over both pictures; its vertices correspond one to one.");
  form.object("warp", "How space bends.", [](auto& warp) { describe_warp(warp); });
  form.object("transition", "How the change is timed.", [](auto& transition) {
    transition.part(&Project::pace);
    transition("blend", &Project::blend, {},
               "`\"linear\"` mixes light; `\"display\"` mixes the values on screen, the look of old tools");
  });
  form("output", &Project::output, {}, "What comes out.");
}

}  // namespace morphkit::project
