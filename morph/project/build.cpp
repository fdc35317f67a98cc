#include "morph/project/build.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

#include "morph/project/values.h"

namespace morphkit::project {
namespace {

using json::Node;

/// Writes an object key by key, leaving defaults out unless they are wanted.
class ObjectBuilder {
 public:
  explicit ObjectBuilder(bool defaults) : defaults_(defaults) {}

  void always(const char* key, Node value) { node_.set(key, std::move(value)); }
  void unless(bool is_default, const char* key, Node value) {
    if (defaults_ || !is_default) always(key, std::move(value));
  }
  void number(const char* key, const std::optional<double>& value) {
    if (value) always(key, Node::of_number(*value));
  }
  /// An object that says nothing is left out.
  void object(const char* key, ObjectBuilder&& value) {
    const bool empty = value.node_.items.empty();
    unless(empty, key, std::move(value.node_));
  }
  Node take() { return std::move(node_); }

 private:
  bool defaults_;
  Node node_ = Node::object();
};

Node point_node(const cv::Point2d& point) {
  Node node = Node::array();
  node.push(Node::of_number(point.x));
  node.push(Node::of_number(point.y));
  return node;
}

Node points_node(const std::vector<cv::Point2d>& points) {
  Node node = Node::array();
  for (const cv::Point2d& point : points) node.push(point_node(point));
  return node;
}

void add_pull(ObjectBuilder& warp, const Pull& pull) {
  warp.number("a", pull.a);
  warp.number("b", pull.b);
  warp.number("p", pull.p);
  if (pull.scale) warp.always("scale", named(kScales, *pull.scale));
  if (pull.between) warp.always("between", named(kBetweens, *pull.between));
  warp.number("turns", pull.turns);
}

void add_pace(ObjectBuilder& transition, const Pace& pace, bool defaults) {
  if (pace.shape) transition.always("shape", timing_node(*pace.shape, defaults));
  if (pace.dissolve) transition.always("dissolve", timing_node(*pace.dissolve, defaults));
}

void add_influence(ObjectBuilder& owner, const Pull& pull, const Pace& pace, bool defaults) {
  ObjectBuilder warp(defaults), transition(defaults);
  add_pull(warp, pull);
  add_pace(transition, pace, defaults);
  owner.object("warp", std::move(warp));
  owner.object("transition", std::move(transition));
}

Node geometry_node(const Feature& feature, bool defaults) {
  ObjectBuilder geometry(defaults);
  const bool is_point = std::holds_alternative<Point>(feature.mark);
  const auto side = [&](const Points& points) { return is_point ? point_node(points.at(0)) : points_node(points); };
  geometry.always("source", side(feature.places[kSource]));
  geometry.always("destination", side(feature.places[kDestination]));
  if (const auto* curve = std::get_if<Curve>(&feature.mark)) {
    geometry.unless(curve->kind == Curve{}.kind, "spline", named(kCurves, curve->kind));
    geometry.unless(!curve->closed, "closed", Node::of_bool(curve->closed));
  }
  return geometry.take();
}

Node feature_node(const Feature& feature, bool defaults) {
  constexpr std::array kMarks{"line", "point", "curve"};
  ObjectBuilder object(defaults);
  object.always("id", Node::string(feature.id));
  if (!feature.group.empty()) object.always("group", Node::string(feature.group));
  object.always(kMarks[feature.mark.index()], geometry_node(feature, defaults));
  add_influence(object, feature.pull, feature.pace, defaults);
  return object.take();
}

Node group_node(const Group& group, bool defaults) {
  ObjectBuilder object(defaults);
  object.always("id", Node::string(group.id));
  add_influence(object, group.pull, group.pace, defaults);
  return object.take();
}

template <typename T>
Node list_node(const std::vector<T>& list, Node (*item)(const T&, bool), bool defaults) {
  Node node = Node::array();
  node.expand = true;
  for (const T& value : list) node.push(item(value, defaults));
  return node;
}

Node picture_node(const Picture& picture) {
  ObjectBuilder object(false);
  object.always("image", Node::string(picture.image.string()));
  if (!picture.colorspace.empty()) object.always("colorspace", Node::string(picture.colorspace));
  return object.take();
}

Node integers_node(std::initializer_list<int> values) {
  Node node = Node::array();
  for (const int value : values) node.push(Node::of_number(value));
  return node;
}

Node vertices_node(const std::vector<cv::Point2d>& vertices, int columns) {
  if (vertices.empty()) return Node::string("uniform");
  Node node = points_node(vertices);
  node.per_line = static_cast<std::size_t>(columns);
  return node;
}

Node mesh_group_node(const MeshGroup& group, bool defaults) {
  Node vertices = Node::array();
  for (const cv::Point& vertex : group.vertices) vertices.push(integers_node({vertex.x, vertex.y}));
  ObjectBuilder object(defaults);
  object.always("group", Node::string(group.group));
  object.always("vertices", std::move(vertices));
  return object.take();
}

Node mesh_node(const Mesh& mesh, bool defaults) {
  ObjectBuilder object(defaults);
  object.always("size", integers_node({mesh.columns, mesh.rows}));
  object.unless(mesh.vertices[kSource].empty(), "source", vertices_node(mesh.vertices[kSource], mesh.columns));
  object.unless(mesh.vertices[kDestination].empty(), "destination",
                vertices_node(mesh.vertices[kDestination], mesh.columns));
  object.unless(mesh.groups.empty(), "groups", list_node(mesh.groups, mesh_group_node, defaults));
  Node node = object.take();
  node.expand = true;
  return node;
}

ObjectBuilder warp_object(const Project& project, bool defaults) {
  ObjectBuilder warp(defaults);
  if (project.warp.method) warp.always("method", named(kMethods, *project.warp.method));
  warp.unless(project.warp.mesh.spline == Warp{}.mesh.spline, "spline", named(kMeshSplines, project.warp.mesh.spline));
  warp.unless(project.warp.mesh.order == Warp{}.mesh.order, "order", named(kPassOrders, project.warp.mesh.order));
  add_pull(warp, project.pull);
  warp.unless(project.warp.lines.field == Warp{}.lines.field, "field", named(kFields, project.warp.lines.field));
  warp.unless(project.warp.filter == Warp{}.filter, "filter", named(kFilters, project.warp.filter));
  warp.unless(!project.warp.border, "border", named(kBorders, project.warp.border));
  return warp;
}

ObjectBuilder output_object(const Output& output, bool defaults) {
  const Output usual;
  ObjectBuilder object(defaults);
  if (output.size) object.always("size", integers_node({output.size->width, output.size->height}));
  object.unless(output.fit == usual.fit, "fit", named(kFits, output.fit));
  object.unless(output.frames == usual.frames, "frames", Node::of_number(output.frames));
  object.unless(output.start == usual.start, "start", Node::of_number(output.start));
  object.unless(output.fps == usual.fps, "fps", fps_node(output.fps));
  object.unless(output.background == usual.background, "background", background_node(output.background));
  return object;
}

}  // namespace

json::Node build(const Project& project, bool defaults) {
  ObjectBuilder transition(defaults);
  add_pace(transition, project.pace, defaults);
  transition.unless(project.blend == Project{}.blend, "blend", named(kBlends, project.blend));

  ObjectBuilder root(defaults);
  root.always("morphkit", Node::of_number(1));
  root.always("source", picture_node(project.pictures[kSource]));
  root.always("destination", picture_node(project.pictures[kDestination]));
  root.unless(project.groups.empty(), "groups", list_node(project.groups, group_node, defaults));
  root.unless(project.features.empty(), "features", list_node(project.features, feature_node, defaults));
  if (project.mesh) root.always("mesh", mesh_node(*project.mesh, defaults));
  root.object("warp", warp_object(project, defaults));
  root.object("transition", std::move(transition));
  root.object("output", output_object(project.output, defaults));
  Node node = root.take();
  node.expand = true;
  return node;
}

}  // namespace morphkit::project
