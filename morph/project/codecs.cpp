#include "morph/project/codecs.h"

#include <cmath>
#include <initializer_list>

namespace morphkit::project {

using json::Kind;
using json::Node;

namespace {

Node integers_node(std::initializer_list<int> values) {
  Node node = Node::array();
  for (const int value : values) node.push(Node::of_number(value));
  return node;
}

cv::Point2d read_point(const json::Cursor& at) {
  at.expect_array(2, 2, "a point [x, y] in pixels");
  return {at.item(0).number(-kMaxCoordinate, kMaxCoordinate), at.item(1).number(-kMaxCoordinate, kMaxCoordinate)};
}

void read_points(const json::Cursor& at, std::size_t least, std::size_t most, const std::string& what, Points& points) {
  at.expect_array(least, most, what);
  points.clear();
  points.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) points.push_back(read_point(at.item(i)));
}

Node point_node(const cv::Point2d& point) {
  Node node = Node::array();
  node.push(Node::of_number(point.x));
  node.push(Node::of_number(point.y));
  return node;
}

Node points_node(const Points& points) {
  Node node = Node::array();
  for (const cv::Point2d& point : points) node.push(point_node(point));
  return node;
}

Node pair_of(const Node& item) {
  Node items = Node::array();
  items.push(item);
  items.push(item);
  return items;
}

Node point_schema() {
  return array_schema(pair_of(number_schema("number", -kMaxCoordinate, kMaxCoordinate)), true, 2, 2);
}

}  // namespace

Node number_schema(const char* type, double least, double most) {
  Node node = Node::object();
  node.set("type", Node::string(type));
  node.set("minimum", Node::of_number(least));
  node.set("maximum", Node::of_number(most));
  return node;
}

Node strings_schema(std::span<const std::string_view> words) {
  Node list = Node::array(), node = Node::object();
  for (const std::string_view word : words) list.push(Node::string(std::string(word)));
  node.set("enum", std::move(list));
  return node;
}

Node array_schema(Node items, bool tuple, double least, double most) {
  Node node = Node::object();
  node.set("type", Node::string("array"));
  node.set(tuple ? "prefixItems" : "items", std::move(items));
  if (least > 0) node.set("minItems", Node::of_number(least));
  node.set("maxItems", Node::of_number(most));
  return node;
}

Node name_schema() {
  Node node = Node::object();
  node.set("type", Node::string("string"));
  node.set("minLength", Node::of_number(1));
  return node;
}

std::string sentence_of(std::string_view sentence, const Facts& facts, bool is_number) {
  std::string text(sentence);
  if (is_number && std::isfinite(facts.least)) {
    text += fmt::format("; {} to {}", json::number_text(facts.least), json::number_text(facts.most));
    if (facts.whole) text += ", whole";
  }
  return text;
}

std::string default_text(const Node& value) {
  switch (value.kind()) {
    case Kind::kString:
      return "`" + value.text() + "`";
    case Kind::kBool:
      return value.boolean() ? "`true`" : "`false`";
    case Kind::kNumber:
      return json::number_text(value.number());
    default:
      return value.size() == 0 ? "none" : json::write(value, "");
  }
}

Node Codec<bool>::schema(const Facts&) {
  Node node = Node::object();
  node.set("type", Node::string("boolean"));
  return node;
}

void Codec<std::string>::read(const json::Cursor& at, std::string& value, const Facts& facts) {
  if (facts.words.empty()) {
    value = at.name(std::string(facts.what));
    return;
  }
  std::vector<Word<std::string_view>> names;
  for (const std::string_view word : facts.words) names.emplace_back(word, word);
  value = at.choice<std::string_view>(std::string(facts.what), names);
}

Node Codec<std::string>::schema(const Facts& facts) {
  return facts.words.empty() ? name_schema() : strings_schema(facts.words);
}

void Codec<Points>::read(const json::Cursor& at, Points& value, const Facts& facts) {
  if (facts.most == 1) {
    value = {read_point(at)};
  } else {
    read_points(at, static_cast<std::size_t>(facts.least), static_cast<std::size_t>(facts.most),
                std::string(facts.what), value);
  }
}

Node Codec<Points>::write(const Points& value, const Facts& facts, bool) {
  return facts.most == 1 ? point_node(value.at(0)) : points_node(value);
}

Node Codec<Points>::schema(const Facts& facts) {
  return facts.most == 1 ? point_schema() : array_schema(point_schema(), false, facts.least, facts.most);
}

void Codec<cv::Size>::read(const json::Cursor& at, cv::Size& value, const Facts&) {
  at.expect_array(2, 2, "[width, height] in pixels");
  value = cv::Size(at.item(0).integer(1, kMaxSize), at.item(1).integer(1, kMaxSize));
  if (static_cast<double>(value.width) * value.height > kMaxArea) {
    at.fail(fmt::format("{} x {} is more than {} pixels", value.width, value.height, json::number_text(kMaxArea)));
  }
}

Node Codec<cv::Size>::write(const cv::Size& value, const Facts&, bool) {
  return integers_node({value.width, value.height});
}

Node Codec<cv::Size>::schema(const Facts&) {
  return array_schema(pair_of(number_schema("integer", 1, kMaxSize)), true, 2, 2);
}

void Codec<std::vector<cv::Point>>::read(const json::Cursor& at, std::vector<cv::Point>& value, const Facts&) {
  at.expect_array(0, kMaxMeshVertices, fmt::format("an array of at most {} vertices [column, row]", kMaxMeshVertices));
  value.clear();
  value.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const json::Cursor vertex = at.item(i);
    vertex.expect_array(2, 2, "a vertex [column, row]");
    // `check` knows how large the mesh is.
    value.emplace_back(vertex.item(0).integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()),
                       vertex.item(1).integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
  }
}

Node Codec<std::vector<cv::Point>>::write(const std::vector<cv::Point>& value, const Facts&, bool) {
  Node node = Node::array();
  for (const cv::Point& vertex : value) node.push(integers_node({vertex.x, vertex.y}));
  return node;
}

Node Codec<std::vector<cv::Point>>::schema(const Facts&) {
  return array_schema(array_schema(pair_of(number_schema("integer", 0, kMaxMeshSize - 1)), true, 2, 2), false, 0,
                      kMaxMeshVertices);
}

void VersionCodec::read(const json::Cursor& at, const Project&, const Facts&) {
  if (!at.is(Kind::kNumber)) at.fail_expected("the version, a number");
  const double value = at.number();
  if (value > 1)
    at.fail(fmt::format("version {} is newer than this program, which reads version 1", json::number_text(value)));
  if (value != 1) at.fail(fmt::format("there is no version {}; expected 1", json::number_text(value)));
}

Node VersionCodec::schema(const Facts&) {
  Node node = Node::object();
  node.set("const", Node::of_number(1));
  return node;
}

void GridCodec::read(const json::Cursor& at, Mesh& mesh, const Facts&) {
  at.expect_array(2, 2, "[columns, rows], the number of vertices in a row and in a column");
  mesh.columns = at.item(0).integer(2, kMaxMeshSize);
  mesh.rows = at.item(1).integer(2, kMaxMeshSize);
  if (mesh.columns * mesh.rows > kMaxMeshVertices) {
    at.fail(fmt::format("{} x {} is more than {} vertices", mesh.columns, mesh.rows, kMaxMeshVertices));
  }
}

Node GridCodec::write(const Mesh& mesh, const Facts&, bool) {
  return integers_node({mesh.columns, mesh.rows});
}

Node GridCodec::schema(const Facts&) {
  return array_schema(pair_of(number_schema("integer", 2, kMaxMeshSize)), true, 2, 2);
}

void read_vertices(const json::Cursor& at, Mesh& mesh, SideIndex side) {
  mesh.vertices[side].clear();
  if (at.is(Kind::kString) && at.string() == "uniform") return;
  const auto count = static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows);
  const std::string wanted =
      fmt::format("{} vertices [x, y] ({} columns x {} rows, row by row)", count, mesh.columns, mesh.rows);
  if (!at.is(Kind::kArray)) at.fail_expected(wanted + " or \"uniform\"");
  read_points(at, count, count, wanted, mesh.vertices[side]);
}

Node write_vertices(const Mesh& mesh, SideIndex side) {
  if (mesh.vertices[side].empty()) return Node::string("uniform");
  Node node = points_node(mesh.vertices[side]);
  node.mutable_hints().per_line = static_cast<std::size_t>(mesh.columns);
  return node;
}

Node vertices_schema() {
  static constexpr std::string_view kUniform[] = {"uniform"};
  Node any = Node::array(), node = Node::object();
  any.push(strings_schema(kUniform));
  any.push(array_schema(point_schema(), false, 4, kMaxMeshVertices));
  node.set("anyOf", std::move(any));
  return node;
}

}  // namespace morphkit::project
