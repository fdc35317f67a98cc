#include "morph/json/merge.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
  return name ? std::string_view(name->text()) : std::string_view();
}

class Merger {
 public:
  Merger(const Document& document, const std::string& text) : document_(document), text_(text) {}

  Node value(Node& original, Node& full, Node& minimal) {
    if (same_meaning(original, full)) return original;
    Node result;
    if (original.is(Kind::kObject) && full.is(Kind::kObject)) {
      if (minimal.is(Kind::kString)) minimal = spelled_out(full, minimal);
      result = object(original, full, minimal);
    } else if (original.is(Kind::kArray) && full.is(Kind::kArray)) {
      result = full.hints().identity.empty() ? array(original, full, minimal) : list(original, full, minimal);
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
    if (!full.hints().same) return false;
    const Document wanted{document_.file, full};
    return full.hints().same(Cursor(document_, original), Cursor(wanted));
  }

  Node object(Node& original, Node& full, Node& minimal) {
    Node result = Node::object();
    for (std::size_t i = 0; i < original.size(); ++i) {
      const std::string& key = original.keys()[i];
      Node* complete = full.find(key);
      if (!complete) continue;
      // What is an object in full and nothing in brief has only defaults, none of which is to be added.
      Node* brief = minimal.find(key);
      if (!brief) brief = complete->is(Kind::kObject) ? &nothing_ : complete;
      result.set(key, value(original.mutable_items()[i], *complete, *brief));
    }
    const bool same_keys = result.size() == original.size();
    const bool added = add_new_keys(result, full, minimal);
    result.fresh = !same_keys || added;
    result.mutable_hints().model = &original;
    return result;
  }

  /// A name alone, such as that of an easing, as the object that says no more.
  static Node spelled_out(const Node& full, const Node& name) {
    Node result = Node::object();
    result.set(full.keys().front(), name);
    return result;
  }

  /// Puts every key of `minimal` that is not there yet behind all that it follows in the canonical order.
  static bool add_new_keys(Node& result, const Node& full, const Node& minimal) {
    bool added = false;
    std::size_t place = 0;
    for (const std::string& key : full.keys()) {
      if (const Node* there = result.find(key)) {
        place = std::max(place, static_cast<std::size_t>(there - result.items().data()) + 1);
        continue;
      }
      const Node* value = minimal.find(key);
      if (!value) continue;
      result.insert(place, key, *value);
      ++place;
      added = true;
    }
    return added;
  }

  /// Items that belong together by their index: points, coordinates, colour channels.
  Node array(Node& original, Node& full, Node& minimal) {
    // The rows of another mesh have another length: nothing of the old lines is worth keeping.
    if (full.hints().per_line > 0 && full.size() != original.size()) return minimal;
    const auto [before, after, brief] = items_of(original, full, minimal);
    Node result = Node::array();
    std::vector<Node>& items = result.mutable_items();
    items.reserve(after.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
      Node& shortest = i < brief.size() ? brief[i] : after[i];
      items.push_back(i < before.size() ? value(before[i], after[i], shortest) : shortest);
    }
    result.fresh = after.size() != before.size();
    result.mutable_hints().model = &original;
    return result;
  }

  /// Items that belong together by their id, in the order of the document; one whose id has changed belongs to the
  /// one that stood in its place.
  Node list(Node& original, Node& full, Node& minimal) {
    const std::string_view key = full.hints().identity;
    const auto [before, after, brief] = items_of(original, full, minimal);
    std::map<std::string_view, std::size_t> by_id, wanted;
    for (std::size_t i = 0; i < before.size(); ++i) by_id.emplace(identity(before[i], key), i);
    for (std::size_t i = 0; i < after.size(); ++i) wanted.emplace(identity(after[i], key), i);
    Node result = Node::array();
    std::vector<Node>& items = result.mutable_items();
    bool same_order = after.size() == before.size();
    for (std::size_t i = 0; i < after.size(); ++i) {
      const auto found = by_id.find(identity(after[i], key));
      const bool renamed = found == by_id.end() && i < before.size() && !wanted.contains(identity(before[i], key));
      if (found == by_id.end() && !renamed) {
        items.push_back(brief[i]);
        same_order = false;
        continue;
      }
      const std::size_t old = renamed ? i : found->second;
      items.push_back(value(before[old], after[i], brief[i]));
      same_order = same_order && old == i;
    }
    result.fresh = !same_order;
    Hints& hints = result.mutable_hints();
    hints.expand = true;
    hints.model = &original;
    return result;
  }

  /// The items of three arrays, each a node of its own.
  struct Items {
    std::vector<Node>&before, &after, &brief;
  };
  Items items_of(Node& original, Node& full, Node& minimal) const {
    locate_items(original, text_);
    return {original.mutable_items(), full.mutable_items(), minimal.mutable_items()};
  }

  const Document& document_;
  const std::string& text_;
  Node nothing_ = Node::object();
};

}  // namespace

Node merge(Document& original, const std::string& text, Node& full, Node& minimal) {
  return Merger(original, text).value(original.root, full, minimal);
}

}  // namespace morphkit::json
