// Keys of the document changed by their addresses: the document as a tree, the values put in their places, read again.
// So every rule and every message is the one that a file meets.

#include "morph/project/set_value.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/words.h"
#include "morph/json/json.h"
#include "morph/project/build.h"
#include "morph/project/read_project.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;

/// VALUE is JSON; anything else is a string.
Node value_of(std::string_view text) {
  try {
    return json::parse(std::string(text), "value");
  } catch (const Error&) {
    return Node::string(std::string(text));
  }
}

/// The index in a list of the item that has the id.
std::size_t index_of(const Node& list, std::string_view id, std::string_view path) {
  std::vector<std::string_view> ids;
  for (const Node& item : list.items()) {
    const Node* own = item.find("id");
    ids.push_back(own ? std::string_view(own->text()) : "");
    if (own && own->text() == id) return ids.size() - 1;
  }
  const auto meant = nearest(id, ids);
  throw Error(ErrorKind::kBadInput, std::string(path),
              fmt::format("nothing here has the id {}{}", json::shown(id),
                          meant ? fmt::format("; did you mean {}?", json::shown(*meant)) : ""));
}

/// A place in the document as it is written: without defaults, and beside it the same place with all of them.
struct Place {
  Node* brief;
  const Node* full;  ///< nothing where the document says nothing

  /// An object written as a single word, such as an easing, becomes an object with that word alone.
  void open() const {
    if (!brief->is(Kind::kString) || !full || !full->is(Kind::kObject)) return;
    Node object = Node::object();
    object.set(full->keys().front(), *brief);
    *brief = std::move(object);
  }

  Place key(std::string_view name) const {
    const Node* inner = full ? full->find(name) : nullptr;
    if (!brief->find(name)) brief->set(std::string(name), Node::object());
    return {brief->find(name), inner};
  }
};

Place find_place(Place at, std::string_view path) {
  std::string_view rest = path;
  do {
    at.open();
    if (!at.brief->is(Kind::kObject)) throw Error(ErrorKind::kBadInput, std::string(path), "there is no such key");
    const std::size_t end = std::min(rest.find_first_of("./"), rest.size());
    at = at.key(rest.substr(0, end));
    const bool enters = end < rest.size() && rest[end] == '/';
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!enters) continue;
    const std::size_t id_end = std::min(rest.find('.'), rest.size());
    const std::size_t index = index_of(*at.brief, rest.substr(0, id_end), path);
    at = {&at.brief->mutable_items()[index], at.full ? &at.full->items()[index] : nullptr};
    rest.remove_prefix(std::min(id_end + 1, rest.size()));
  } while (!rest.empty());
  return at;
}

/// The document with all values in their places.
Node tree_with(const Project& project, std::span<const Setting> settings, const Node& full) {
  Node root = build(project, false);
  for (const Setting& setting : settings) *find_place({&root, &full}, setting.path).brief = value_of(setting.value);
  return root;
}

/// All defaults are needed, and their large tree is built, only where a word becomes an object.
Node tree_with(const Project& project, std::span<const Setting> settings) {
  try {
    return tree_with(project, settings, Node::object());
  } catch (const Error&) {
    return tree_with(project, settings, build(project, true));
  }
}

/// Puts all values into one tree and reads that.
Project with_values(const Project& project, std::span<const Setting> settings) {
  const std::string& path = settings.back().path;
  const json::Document document{path, tree_with(project, settings)};
  try {
    Project changed = read_project(document);
    changed.file = project.file;
    changed.original = project.original;
    return changed;
  } catch (const Error& error) {
    throw Error(error.kind(), path, error.message());
  }
}

}  // namespace

void set_values(Project& project, std::span<const Setting> settings) {
  if (settings.empty()) return;
  try {
    project = with_values(project, settings);
    return;
  } catch (const Error&) {
    if (settings.size() == 1) throw;
  }
  // One by one: a setting may continue an earlier one (the delay of an easing), and the message names the wrong one.
  Project changed = project;
  for (const Setting& setting : settings) changed = with_values(changed, {&setting, 1});
  project = std::move(changed);
}

void set_value(Project& project, std::string_view path, std::string_view value) {
  const Setting setting{std::string(path), std::string(value)};
  set_values(project, {&setting, 1});
}

}  // namespace morphkit::project
