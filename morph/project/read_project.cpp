#include "morph/project/read_project.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "morph/project/limits.h"
#include "morph/project/read_parts.h"
#include "morph/project/values.h"

namespace morphkit::project {
namespace {

using json::Kind;

void read_number(const json::Cursor& at, std::string_view key, double least, double most,
                 std::optional<double>& value) {
  if (const auto found = at.find(key)) value = found->number(least, most);
}

/// The keys of "warp" that groups and features share with the project.
void read_pull(const json::Cursor& at, Pull& pull) {
  read_number(at, "a", 0, kMaxCoordinate, pull.a);
  read_number(at, "b", 0, kMaxFalloff, pull.b);
  read_number(at, "p", 0, 1, pull.p);
  if (const auto scale = at.find("scale")) pull.scale = choose(*scale, "scale", kScales);
  if (const auto between = at.find("between")) pull.between = choose(*between, "way between", kBetweens);
  if (const auto turns = at.find("turns")) pull.turns = turns->integer(-kMaxTurns, kMaxTurns);
}

void read_pace(const json::Cursor& at, Pace& pace) {
  if (const auto shape = at.find("shape")) pace.shape = read_timing(*shape);
  if (const auto dissolve = at.find("dissolve")) pace.dissolve = read_timing(*dissolve);
}

/// "warp" and "transition" of a group or a feature.
template <typename T>
void read_influence(const json::Cursor& at, T& owner) {
  if (const auto warp = at.find("warp")) {
    warp->allow_keys({"a", "b", "p", "scale", "between", "turns"});
    read_pull(*warp, owner.pull);
  }
  if (const auto transition = at.find("transition")) {
    transition->allow_keys({"shape", "dissolve"});
    read_pace(*transition, owner.pace);
  }
}

constexpr const char* kBothSides = "a feature needs its place on both sides";

/// The place on both sides. @param read  from the cursor of one side.
template <typename Read>
void read_places(const json::Cursor& at, Feature& feature, const Read& read) {
  feature.places[kSource] = read(at.require("source", kBothSides));
  feature.places[kDestination] = read(at.require("destination", kBothSides));
}

/// Refuses a mark whose first and last point coincide on one side only.
void require_joined_alike(const json::Cursor& at, const Feature& feature, const char* message) {
  const auto joined = [&](SideIndex side) { return feature.places[side].front() == feature.places[side].back(); };
  if (joined(kSource) == joined(kDestination)) return;
  at.require(joined(kSource) ? "source" : "destination", kBothSides).fail(message);
}

void read_line(const json::Cursor& at, Feature& feature) {
  at.allow_keys({"source", "destination"});
  feature.mark = Line{};
  read_places(at, feature, [](const json::Cursor& side) {
    return read_points(side, 2, 2, "the two ends of a line [[x, y], [x, y]]");
  });
  require_joined_alike(at, feature,
                       "both ends lie at the same place on this side only; move one of them, or make it a \"point\"");
}

void read_point_feature(const json::Cursor& at, Feature& feature) {
  at.allow_keys({"source", "destination"});
  feature.mark = Point{};
  read_places(at, feature, [](const json::Cursor& side) { return Points{read_point(side)}; });
}

void read_curve(const json::Cursor& at, Feature& feature) {
  at.allow_keys({"source", "destination", "spline", "closed"});
  Curve curve;
  if (const auto spline = at.find("spline")) curve.kind = choose(*spline, "spline", kCurves);
  if (const auto closed = at.find("closed")) curve.closed = closed->boolean();
  feature.mark = curve;
  read_places(at, feature, [&](const json::Cursor& side) {
    Points points = read_points(side, 2, kMaxPoints, fmt::format("2 to {} points [[x, y], ...]", kMaxPoints));
    if (const auto problem = motion::Curve::problem(curve.kind, points, curve.closed)) side.fail(*problem);
    return points;
  });
  if (curve.closed) return;
  require_joined_alike(at, feature,
                       "the curve ends where it starts on this side only; let both sides do so, or neither");
}

Feature read_feature(const json::Cursor& at) {
  at.allow_keys({"id", "group", "line", "point", "curve", "warp", "transition"});
  Feature feature;
  feature.id = at.require("id", "give the feature a name of its own").name("an id");
  if (const auto group = at.find("group")) feature.group = group->name("a group");
  const auto line = at.find("line"), point = at.find("point"), curve = at.find("curve");
  if (line.has_value() + point.has_value() + curve.has_value() != 1) {
    at.fail("a feature is exactly one of \"line\", \"point\" and \"curve\"");
  }
  if (line) read_line(*line, feature);
  if (point) read_point_feature(*point, feature);
  if (curve) read_curve(*curve, feature);
  read_influence(at, feature);
  return feature;
}

Group read_group(const json::Cursor& at) {
  at.allow_keys({"id", "warp", "transition"});
  Group group;
  group.id = at.require("id", "give the group a name of its own").name("an id");
  read_influence(at, group);
  return group;
}

/// Reads an array of things that have ids of their own.
template <typename T>
std::vector<T> read_list(const json::Cursor& root, const char* key, T (*read)(const json::Cursor&)) {
  std::vector<T> list;
  const auto at = root.find(key);
  if (!at) return list;
  at->expect_array(0, kMaxFeatures, fmt::format("an array of at most {} {}", kMaxFeatures, key));
  std::set<std::string> ids;
  for (std::size_t i = 0; i < at->size(); ++i) {
    const json::Cursor item = at->item(i);
    list.push_back(read(item));
    if (!ids.insert(list.back().id).second) {
      item.find("id")->fail(
          fmt::format("the id {} occurs twice in {}; each needs its own", json::shown(list.back().id), key));
    }
  }
  return list;
}

void check_groups(const json::Cursor& root, const std::vector<Feature>& features, const std::vector<Group>& groups) {
  const std::set<std::string_view> known = group_ids(groups);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features[i].group.empty()) continue;
    check_group(*root.find("features")->item(i).find("group"), features[i].group, known);
  }
}

Picture read_picture(const json::Cursor& at, const char* id) {
  at.allow_keys({"image", "colorspace"});
  static constexpr std::pair<std::string_view, std::string_view> kSpaces[] = {{"srgb", "srgb"}, {"linear", "linear"}};
  Picture picture;
  picture.id = id;
  picture.image = at.require("image", "name a picture, e.g. {\"image\": \"cat.png\"}").name("the path of an image");
  if (const auto space = at.find("colorspace")) picture.colorspace = choose(*space, "colour space", kSpaces);
  return picture;
}

void read_warp(const json::Cursor& at, Project& project) {
  at.allow_keys({"method", "spline", "order", "a", "b", "p", "scale", "between", "turns", "field", "filter", "border"});
  if (const auto method = at.find("method")) project.warp.method = choose(*method, "method", kMethods);
  if (const auto spline = at.find("spline")) project.warp.mesh.spline = choose(*spline, "spline", kMeshSplines);
  if (const auto order = at.find("order")) project.warp.mesh.order = choose(*order, "order", kPassOrders);
  if (const auto field = at.find("field")) project.warp.lines.field = choose(*field, "field", kFields);
  if (const auto filter = at.find("filter")) project.warp.filter = choose(*filter, "filter", kFilters);
  if (const auto border = at.find("border")) project.warp.border = choose(*border, "border", kBorders);
  read_pull(at, project.pull);
}

/// What warp and mesh must agree on.
void check_method(const json::Cursor& root, const Project& project) {
  // The setting may come from elsewhere than this document (read_features_over).
  const auto place = [&](const char* key) {
    const auto warp = root.find("warp");
    const auto setting = warp ? warp->find(key) : std::nullopt;
    return setting ? *setting : root;
  };
  if (method_name_of(project) != MethodName::kMesh) return;
  if (!project.mesh) {
    place("method").fail(
        R"(the method "mesh" needs a mesh; add "mesh": {"size": [columns, rows], "source": ..., "destination": ...})");
  }
  if (project.warp.border == warp::Border::kMirror) {
    place("border").fail(R"(the method "mesh" cannot mirror; expected the border "auto", "transparent" or "clamp")");
  }
}

void read_transition(const json::Cursor& at, Project& project) {
  at.allow_keys({"shape", "dissolve", "blend"});
  read_pace(at, project.pace);
  if (const auto blend = at.find("blend")) project.blend = choose(*blend, "blend", kBlends);
}

cv::Size read_size(const json::Cursor& at) {
  at.expect_array(2, 2, "[width, height] in pixels");
  const cv::Size size(at.item(0).integer(1, kMaxSize), at.item(1).integer(1, kMaxSize));
  if (static_cast<double>(size.width) * size.height > kMaxArea) {
    at.fail(fmt::format("{} x {} is more than {} pixels", size.width, size.height, json::number_text(kMaxArea)));
  }
  return size;
}

Output read_output(const json::Cursor& at) {
  at.allow_keys({"size", "fit", "frames", "start", "fps", "background"});
  Output output;
  if (const auto size = at.find("size")) output.size = read_size(*size);
  if (const auto fit = at.find("fit")) output.fit = choose(*fit, "fit", kFits);
  if (const auto frames = at.find("frames")) output.frames = frames->integer(1, kMaxFrames);
  if (const auto start = at.find("start")) output.start = start->integer(0, kMaxStart);
  if (const auto fps = at.find("fps")) output.fps = read_fps(*fps);
  if (const auto background = at.find("background")) output.background = read_background(*background);
  return output;
}

/// The version comes first: a newer file may have keys that this program cannot know.
void check_version(const json::Cursor& root) {
  if (!root.is(Kind::kObject)) root.fail_expected("an object {\"morphkit\": 1, ...}");
  const json::Cursor version = root.require("morphkit", "the version of the file's form, \"morphkit\": 1");
  if (!version.is(Kind::kNumber)) version.fail_expected("the version, a number");
  const double value = version.node().number;
  if (value > 1)
    version.fail(fmt::format("version {} is newer than this program, which reads version 1", json::number_text(value)));
  if (value != 1) version.fail(fmt::format("there is no version {}; expected 1", json::number_text(value)));
  root.allow_keys({"morphkit", "source", "destination", "groups", "features", "mesh", "warp", "transition", "output"});
}

}  // namespace

Project read_project(const json::Document& document) {
  const json::Cursor root(document);
  check_version(root);
  Project project;
  project.pictures = {
      read_picture(root.require("source", "the picture to start from, {\"image\": \"cat.png\"}"), "source"),
      read_picture(root.require("destination", "the picture to arrive at, {\"image\": \"tiger.png\"}"), "destination")};
  project.groups = read_list(root, "groups", read_group);
  project.features = read_list(root, "features", read_feature);
  check_groups(root, project.features, project.groups);
  if (const auto mesh = root.find("mesh")) project.mesh = read_mesh(*mesh, project.groups);
  if (const auto warp = root.find("warp")) read_warp(*warp, project);
  if (const auto transition = root.find("transition")) read_transition(*transition, project);
  if (const auto output = root.find("output")) project.output = read_output(*output);
  check_method(root, project);
  return project;
}

void read_features_over(Project& project, const json::Document& document) {
  const json::Cursor root(document);
  check_version(root);
  if (!root.find("features") && !root.find("mesh")) {
    root.fail("this file is asked for what corresponds; it has neither \"features\" nor a \"mesh\"");
  }
  // What is not taken over is checked all the same: a file is good or bad whatever it is used for.
  for (const char* side : {"source", "destination"}) {
    if (const auto at = root.find(side)) read_picture(*at, side);
  }
  if (const auto output = root.find("output")) read_output(*output);
  Project result = project;
  result.groups = read_list(root, "groups", read_group);
  result.features = read_list(root, "features", read_feature);
  check_groups(root, result.features, result.groups);
  result.mesh.reset();
  if (const auto mesh = root.find("mesh")) result.mesh = read_mesh(*mesh, result.groups);
  if (const auto warp = root.find("warp")) read_warp(*warp, result);
  if (const auto transition = root.find("transition")) read_transition(*transition, result);
  check_method(root, result);
  project = std::move(result);
}

}  // namespace morphkit::project
