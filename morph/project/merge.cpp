#include "morph/project/merge.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "morph/project/values.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;

/// What has a place in the original keeps it, so that the text around it can be kept.
void take_place(Node& node, const Node& original) {
  node.key_begin = original.key_begin;
  node.begin = original.begin;
  node.end = original.end;
}

/// The name by which an item of a list is known: of a feature or a group its id, of vertices their group.
std::string_view identity(const Node& item) {
  const Node* id = item.find("id");
  return id ? id->text : item.find("group")->text;
}

class Merger {
 public:
  explicit Merger(const json::Document& document) : document_(document) {}

  Node value(std::string_view key, const Node& original, const Node& full, const Node& minimal) const {
    if (same_meaning(key, original, full)) return original;
    Node result;
    if (original.is(Kind::kObject) && full.is(Kind::kObject)) {
      result = object(original, full, minimal.is(Kind::kString) ? spelled_out(full, minimal) : minimal);
    } else if (original.is(Kind::kArray) && full.is(Kind::kArray)) {
      result = key == "features" || key == "groups" ? list(original, full, minimal) : array(original, full, minimal);
    } else {
      result = minimal;
    }
    take_place(result, original);
    return result;
  }

 private:
  /// Whether the original says, perhaps in other words, what is to be said.
  bool same_meaning(std::string_view key, const Node& original, const Node& full) const {
    if (json::same_value(original, full)) return true;
    const bool has_spellings = key == "shape" || key == "dissolve" || key == "fps" || key == "background";
    if (!has_spellings) return false;
    const json::Document wanted{document_.file, full};
    const json::Cursor before(document_, original), after(wanted);
    if (key == "fps") return read_fps(before) == read_fps(after);
    if (key == "background") return read_background(before) == read_background(after);
    return read_timing(before) == read_timing(after);
  }

  Node object(const Node& original, const Node& full, const Node& minimal) const {
    Node result = Node::object();
    for (std::size_t i = 0; i < original.items.size(); ++i) {
      const std::string& key = original.keys[i];
      const Node* complete = full.find(key);
      if (!complete) continue;
      // What is an object in full and nothing in brief has only defaults, none of which is to be added.
      const Node* brief = minimal.find(key);
      if (!brief) brief = complete->is(Kind::kObject) ? &nothing_ : complete;
      result.set(key, value(key, original.items[i], *complete, *brief));
    }
    const bool same_keys = result.items.size() == original.items.size();
    const bool added = add_new_keys(result, full, minimal);
    result.fresh = !same_keys || added;
    result.model = &original;
    return result;
  }

  /// A name alone, such as that of an easing, as the object that says no more.
  static Node spelled_out(const Node& full, const Node& name) {
    Node result = Node::object();
    result.set(full.keys.front(), name);
    return result;
  }

  /// Puts every key of `minimal` that is not there yet behind all that it follows in the canonical order.
  static bool add_new_keys(Node& result, const Node& full, const Node& minimal) {
    bool added = false;
    std::ptrdiff_t place = 0;
    for (const std::string& key : full.keys) {
      const auto there = std::find(result.keys.begin(), result.keys.end(), key);
      if (there != result.keys.end()) {
        place = std::max(place, there - result.keys.begin() + 1);
        continue;
      }
      const Node* value = minimal.find(key);
      if (!value) continue;
      result.keys.insert(result.keys.begin() + place, key);
      result.items.insert(result.items.begin() + place, *value);
      ++place;
      added = true;
    }
    return added;
  }

  /// Items that belong together by their index: points, coordinates, colour channels.
  Node array(const Node& original, const Node& full, const Node& minimal) const {
    // The rows of another mesh have another length: nothing of the old lines is worth keeping.
    if (full.per_line > 0 && full.items.size() != original.items.size()) return minimal;
    Node result = Node::array();
    for (std::size_t i = 0; i < full.items.size(); ++i) {
      const bool both = i < minimal.items.size();
      const Node& brief = both ? minimal.items[i] : full.items[i];
      result.push(i < original.items.size() ? value("", original.items[i], full.items[i], brief) : brief);
    }
    result.fresh = full.items.size() != original.items.size();
    result.model = &original;
    return result;
  }

  /// Items that belong together by their id, in the order of the document; one whose id has changed belongs to the
  /// one that stood in its place.
  Node list(const Node& original, const Node& full, const Node& minimal) const {
    std::map<std::string_view, std::size_t> by_id, wanted;
    for (std::size_t i = 0; i < original.items.size(); ++i) by_id.emplace(identity(original.items[i]), i);
    for (std::size_t i = 0; i < full.items.size(); ++i) wanted.emplace(identity(full.items[i]), i);
    Node result = Node::array();
    bool same_order = full.items.size() == original.items.size();
    for (std::size_t i = 0; i < full.items.size(); ++i) {
      const auto found = by_id.find(identity(full.items[i]));
      const bool renamed =
          found == by_id.end() && i < original.items.size() && !wanted.contains(identity(original.items[i]));
      if (found == by_id.end() && !renamed) {
        result.push(minimal.items[i]);
        same_order = false;
        continue;
      }
      const std::size_t before = renamed ? i : found->second;
      result.push(value("", original.items[before], full.items[i], minimal.items[i]));
      same_order = same_order && before == i;
    }
    result.fresh = !same_order;
    result.expand = true;
    result.model = &original;
    return result;
  }

  const json::Document& document_;
  const Node nothing_ = Node::object();
};

}  // namespace

json::Node merge(const json::Document& original, const json::Node& full, const json::Node& minimal) {
  return Merger(original).value("", original.root, full, minimal);
}

}  // namespace morphkit::project
