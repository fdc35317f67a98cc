#include "morph/json/merge.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace morphkit::json {
namespace {

/// What has a place in the original keeps it, so that the text around it can be kept.
void take_place(Node& node, const Node& original) {
  node.key_begin = original.key_begin;
  node.begin = original.begin;
  node.end = original.end;
}

/// The name by which an item of a list is known.
std::string_view identity(const Node& item, std::string_view key) {
  const Node* name = item.find(key);
  return name ? std::string_view(name->text) : std::string_view();
}

class Merger {
 public:
  explicit Merger(const Document& document) : document_(document) {}

  Node value(const Node& original, const Node& full, const Node& minimal) const {
    if (same_meaning(original, full)) return original;
    Node result;
    if (original.is(Kind::kObject) && full.is(Kind::kObject)) {
      result = object(original, full, minimal.is(Kind::kString) ? spelled_out(full, minimal) : minimal);
    } else if (original.is(Kind::kArray) && full.is(Kind::kArray)) {
      result = full.identity.empty() ? array(original, full, minimal) : list(original, full, minimal);
    } else {
      result = minimal;
    }
    take_place(result, original);
    return result;
  }

 private:
  /// Whether the original says, perhaps in other words, what is to be said.
  bool same_meaning(const Node& original, const Node& full) const {
    if (same_value(original, full)) return true;
    if (!full.same) return false;
    const Document wanted{document_.file, full};
    return full.same(Cursor(document_, original), Cursor(wanted));
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
      result.set(key, value(original.items[i], *complete, *brief));
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
      result.push(i < original.items.size() ? value(original.items[i], full.items[i], brief) : brief);
    }
    result.fresh = full.items.size() != original.items.size();
    result.model = &original;
    return result;
  }

  /// Items that belong together by their id, in the order of the document; one whose id has changed belongs to the
  /// one that stood in its place.
  Node list(const Node& original, const Node& full, const Node& minimal) const {
    std::map<std::string_view, std::size_t> by_id, wanted;
    for (std::size_t i = 0; i < original.items.size(); ++i)
      by_id.emplace(identity(original.items[i], full.identity), i);
    for (std::size_t i = 0; i < full.items.size(); ++i) wanted.emplace(identity(full.items[i], full.identity), i);
    Node result = Node::array();
    bool same_order = full.items.size() == original.items.size();
    for (std::size_t i = 0; i < full.items.size(); ++i) {
      const auto found = by_id.find(identity(full.items[i], full.identity));
      const bool renamed = found == by_id.end() && i < original.items.size() &&
                           !wanted.contains(identity(original.items[i], full.identity));
      if (found == by_id.end() && !renamed) {
        result.push(minimal.items[i]);
        same_order = false;
        continue;
      }
      const std::size_t before = renamed ? i : found->second;
      result.push(value(original.items[before], full.items[i], minimal.items[i]));
      same_order = same_order && before == i;
    }
    result.fresh = !same_order;
    result.expand = true;
    result.model = &original;
    return result;
  }

  const Document& document_;
  const Node nothing_ = Node::object();
};

}  // namespace

Node merge(const Document& original, const Node& full, const Node& minimal) {
  return Merger(original).value(original.root, full, minimal);
}

}  // namespace morphkit::json
