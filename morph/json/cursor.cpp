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
  for (std::size_t i = 0; i < from.items().size(); ++i) {
    path += from.is(Kind::kObject) ? pointer_token(from.keys()[i]) : fmt::format("/{}", i);
    if (find_pointer(from.items()[i], target, path)) return true;
    path.resize(length);
  }
  return false;
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
  if (level_ == Level::kNode) return path;
  const std::size_t row = node_->flat().row;
  if (row == 0) return path + fmt::format("/{}", first_);
  path += fmt::format("/{}", first_ / row);
  return level_ == Level::kRow ? path : path + fmt::format("/{}", first_ % row);
}

std::string Cursor::description() const {
  switch (kind()) {
    case Kind::kNull:
      return "null";
    case Kind::kBool:
      return boolean() ? "true" : "false";
    case Kind::kNumber:
      return "the number " + number_text(number());
    case Kind::kString:
      return "the string " + shown(string());
    case Kind::kArray:
      return fmt::format("an array of {}", size());
    case Kind::kObject:
      return "an object";
  }
  return "something else";
}

void Cursor::fail(const std::string& message) const {
  const std::string path = pointer();
  throw Error(ErrorKind::kBadInput, path.empty() ? document_->file : document_->file + ": " + path, message);
}

void Cursor::fail_expected(std::string_view what) const {
  fail(fmt::format("expected {}, found {}", what, description()));
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
  const std::vector<std::string>& keys = node_->keys();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (std::find(allowed.begin(), allowed.end(), keys[i]) == allowed.end()) {
      item(i).fail_unknown("key", keys[i], allowed);
    }
  }
}

std::optional<Cursor> Cursor::find(std::string_view key) const {
  const Node* found = is(Kind::kObject) ? node_->find(key) : nullptr;
  return found ? std::optional(Cursor(*document_, *found)) : std::nullopt;
}

Cursor Cursor::require(std::string_view key, const std::string& why) const {
  const auto found = find(key);
  if (!found) fail(fmt::format("\"{}\" is missing: {}", key, why));
  return *found;
}

void Cursor::expect_array(std::size_t least, std::size_t most, std::string_view what) const {
  if (!is(Kind::kArray) || size() < least || size() > most) fail_expected(what);
}

Cursor Cursor::item(std::size_t i) const {
  if (level_ == Level::kRow) return {*this, Level::kNumber, first_ + i};
  if (!node_->is_flat()) return {*document_, node_->items()[i]};
  const std::size_t row = node_->flat().row;
  return row == 0 ? Cursor(*this, Level::kNumber, i) : Cursor(*this, Level::kRow, i * row);
}

double Cursor::number() const {
  if (!is(Kind::kNumber)) fail_expected("a number");
  return level_ == Level::kNumber ? node_->flat().numbers[first_] : node_->number();
}

double Cursor::number(double least, double most) const {
  const double value = number();
  if (!(value >= least && value <= most)) {
    fail(fmt::format("{} is out of range; expected {} to {}", number_text(value), number_text(least),
                     number_text(most)));
  }
  return value;
}

int Cursor::integer(int least, int most) const {
  if (is(Kind::kNumber) && number() != std::trunc(number())) fail_expected("a whole number");
  return static_cast<int>(number(least, most));
}

bool Cursor::boolean() const {
  if (!is(Kind::kBool)) fail_expected("true or false");
  return node_->boolean();
}

const std::string& Cursor::string() const {
  if (!is(Kind::kString)) fail_expected("a string");
  return node_->text();
}

const std::string& Cursor::path(const std::string& what) const {
  const std::string& text = string();
  if (text.empty()) fail(fmt::format("{} must not be empty", what));
  if (text.find('\0') != std::string::npos) fail(fmt::format("{} holds a NUL character; remove it", what));
  return text;
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
