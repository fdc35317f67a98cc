#include "morph/json/cursor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/words.h"

namespace morphkit::json {
namespace {

/// The pointer from `from` down to `target`, appended to `path`. Walks the tree: an error is told once.
bool find_pointer(const Node& from, const Node* target, std::string& path) {
  if (&from == target) return true;
  const std::size_t length = path.size();
  for (std::size_t i = 0; i < from.items.size(); ++i) {
    path += from.is(Kind::kObject) ? pointer_token(from.keys[i]) : fmt::format("/{}", i);
    if (find_pointer(from.items[i], target, path)) return true;
    path.resize(length);
  }
  return false;
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Kind::kNull:
      return "null";
    case Kind::kBool:
      return node.boolean ? "true" : "false";
    case Kind::kNumber:
      return "the number " + number_text(node.number);
    case Kind::kString:
      return "the string " + shown(node.text);
    case Kind::kArray:
      return fmt::format("an array of {}", node.items.size());
    case Kind::kObject:
      return "an object";
  }
  return "something else";
}

std::string listed(std::span<const std::string_view> words) {
  std::string result;
  for (const std::string_view word : words) result += (result.empty() ? "" : ", ") + shown(word);
  return result;
}

}  // namespace

std::string Cursor::pointer() const {
  std::string path;
  find_pointer(document_->root, node_, path);
  return path;
}

void Cursor::fail(const std::string& message) const {
  const std::string path = pointer();
  throw Error(ErrorCode::kBadInput, path.empty() ? document_->file : document_->file + ": " + path, message);
}

void Cursor::fail_expected(const std::string& what) const {
  fail(fmt::format("expected {}, found {}", what, describe(*node_)));
}

void Cursor::fail_unknown(const std::string& what, std::string_view found,
                          std::span<const std::string_view> allowed) const {
  const auto meant = nearest(found, allowed);
  fail(fmt::format("unknown {} {}; {}", what, shown(found),
                   meant
                       ? fmt::format("did you mean {}?", shown(*meant))
                       : fmt::format("{} {}", allowed.size() == 1 ? "expected" : "expected one of", listed(allowed))));
}

void Cursor::allow_keys(std::span<const std::string_view> allowed) const {
  if (!is(Kind::kObject)) fail_expected("an object");
  for (std::size_t i = 0; i < node_->keys.size(); ++i) {
    if (std::find(allowed.begin(), allowed.end(), node_->keys[i]) == allowed.end()) {
      item(i).fail_unknown("key", node_->keys[i], allowed);
    }
  }
}

std::optional<Cursor> Cursor::find(std::string_view key) const {
  const Node* found = node_->find(key);
  return found ? std::optional(Cursor(*document_, *found)) : std::nullopt;
}

Cursor Cursor::require(std::string_view key, const std::string& why) const {
  const auto found = find(key);
  if (!found) fail(fmt::format("\"{}\" is missing: {}", key, why));
  return *found;
}

void Cursor::expect_array(std::size_t least, std::size_t most, const std::string& what) const {
  if (!is(Kind::kArray) || size() < least || size() > most) fail_expected(what);
}

double Cursor::number(double least, double most) const {
  if (!is(Kind::kNumber)) fail_expected("a number");
  if (!(node_->number >= least && node_->number <= most)) {
    fail(fmt::format("{} is out of range; expected {} to {}", number_text(node_->number), number_text(least),
                     number_text(most)));
  }
  return node_->number;
}

int Cursor::integer(int least, int most) const {
  if (is(Kind::kNumber) && node_->number != std::trunc(node_->number)) fail_expected("a whole number");
  return static_cast<int>(number(least, most));
}

bool Cursor::boolean() const {
  if (!is(Kind::kBool)) fail_expected("true or false");
  return node_->boolean;
}

const std::string& Cursor::string() const {
  if (!is(Kind::kString)) fail_expected("a string");
  return node_->text;
}

const std::string& Cursor::name(const std::string& what) const {
  const std::string& text = string();
  if (text.empty()) fail(fmt::format("{} must not be empty", what));
  const bool control =
      std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (control) fail(fmt::format("{} holds a control character; remove it", what));
  return text;
}

}  // namespace morphkit::json
