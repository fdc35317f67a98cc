#include <algorithm>
#include <cstdint>
#include <utility>

#include "morph/json/json.h"

namespace morphkit::json {

static_assert(sizeof(Node) <= 40, "a node is to stay small: there are up to kMaxNodes of them");
static_assert(kMaxFileBytes <= UINT32_MAX, "places in a text are 32 bits wide");

namespace {

Node row_node(const double* numbers, std::size_t count) {
  Node row = Node::array();
  for (std::size_t i = 0; i < count; ++i) row.push(Node::of_number(numbers[i]));
  return row;
}

std::vector<Node> nodes_of(const Flat& flat) {
  std::vector<Node> nodes;
  nodes.reserve(flat.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    nodes.push_back(flat.row == 0 ? Node::of_number(flat.numbers[i])
                                  : row_node(flat.numbers.data() + i * flat.row, flat.row));
  }
  return nodes;
}

bool same_items(const std::vector<Node>& a, const std::vector<Node>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_value);
}

}  // namespace

const std::string& Node::text() const noexcept {
  static const std::string kNone;
  const auto* text = std::get_if<Box<std::string>>(&value_);
  return text ? **text : kNone;
}

const std::vector<std::string>& Node::keys() const noexcept {
  static const std::vector<std::string> kNone;
  const auto* members = std::get_if<Box<Members>>(&value_);
  return members ? (*members)->keys : kNone;
}

const std::vector<Node>& Node::items() const noexcept {
  static const std::vector<Node> kNone;
  if (const auto* members = std::get_if<Box<Members>>(&value_)) return (*members)->items;
  const auto* list = std::get_if<Box<std::vector<Node>>>(&value_);
  return list ? **list : kNone;
}

std::vector<Node>& Node::mutable_items() {
  if (auto* members = std::get_if<Box<Members>>(&value_)) return (*members)->items;
  if (is_flat()) value_ = Box<std::vector<Node>>(nodes_of(flat()));
  return *std::get<Box<std::vector<Node>>>(value_);
}

const Node* Node::find(std::string_view key) const noexcept {
  const auto it = std::find(keys().begin(), keys().end(), key);
  return it == keys().end() ? nullptr : &items()[static_cast<std::size_t>(it - keys().begin())];
}

Node* Node::find(std::string_view key) noexcept {
  return const_cast<Node*>(std::as_const(*this).find(key));
}

void Node::insert(std::size_t place, std::string key, Node value) {
  Members& members = *std::get<Box<Members>>(value_);
  const auto offset = static_cast<std::ptrdiff_t>(place);
  members.keys.insert(members.keys.begin() + offset, std::move(key));
  members.items.insert(members.items.begin() + offset, std::move(value));
}

bool Node::stays_flat(const Node& value) const noexcept {
  if (!is_flat() || value.hints_ || value.end > 0) return false;
  const bool empty = flat().numbers.empty();
  if (value.is(Kind::kNumber)) return empty || flat().row == 0;
  if (!value.is_flat() || value.flat().row != 0 || value.size() == 0) return false;
  return empty || flat().row == value.size();
}

void Node::push(Node value) {
  if (!absorb(value)) mutable_items().push_back(std::move(value));
}

bool Node::absorb(const Node& value) {
  if (!stays_flat(value)) return false;
  Flat& own = *std::get<Box<Flat>>(value_);
  if (value.is(Kind::kNumber)) {
    own.numbers.push_back(value.number());
  } else {
    const std::vector<double>& row = value.flat().numbers;
    own.row = row.size();
    own.numbers.insert(own.numbers.end(), row.begin(), row.end());
  }
  return true;
}

void Node::clear() noexcept {
  Flat& own = *std::get<Box<Flat>>(value_);
  own.numbers.clear();
  own.row = 0;
}

const Hints& Node::hints() const noexcept {
  static const Hints kNone;
  return hints_ ? *hints_ : kNone;
}

Hints& Node::mutable_hints() {
  if (!hints_) hints_ = Box<Hints>(Hints{});
  return *hints_;
}

bool same_value(const Node& a, const Node& b) {
  if (a.kind() != b.kind() || a.size() != b.size()) return false;
  switch (a.kind()) {
    case Kind::kNull:
      return true;
    case Kind::kBool:
      return a.boolean() == b.boolean();
    case Kind::kNumber:
      return a.number() == b.number();
    case Kind::kString:
      return a.text() == b.text();
    case Kind::kArray:
      break;
    case Kind::kObject:
      return std::equal(a.keys().begin(), a.keys().end(), a.items().begin(),
                        [&](const std::string& key, const Node& item) {
                          const Node* other = b.find(key);
                          return other && same_value(item, *other);
                        });
  }
  if (a.is_flat() && b.is_flat()) return a.flat() == b.flat();
  if (a.is_flat()) return same_items(nodes_of(a.flat()), b.items());
  if (b.is_flat()) return same_items(a.items(), nodes_of(b.flat()));
  return same_items(a.items(), b.items());
}

}  // namespace morphkit::json
