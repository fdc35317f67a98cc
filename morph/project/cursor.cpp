#include "morph/project/cursor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "morph/error.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;

/// The pointer from `from` down to `target`, appended to `path`. Walks the tree: an error is told once.
bool find_pointer(const Node& from, const Node* target, std::string& path) {
  if (&from == target) return true;
  const std::size_t length = path.size();
  for (std::size_t i = 0; i < from.items.size(); ++i) {
    path += from.is(Kind::kObject) ? json::pointer_token(from.keys[i]) : fmt::format("/{}", i);
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
      return "the number " + json::number_text(node.number);
    case Kind::kString:
      return "the string " + json::shown(node.text);
    case Kind::kArray:
      return fmt::format("an array of {}", node.items.size());
    case Kind::kObject:
      return "an object";
  }
  return "something else";
}

std::string listed(std::span<const std::string_view> words) {
  std::string result;
  for (const std::string_view word : words) result += (result.empty() ? "" : ", ") + json::shown(word);
  return result;
}

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (Damerau 1964, optimal string
/// alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, substituted});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> allowed) {
  constexpr std::size_t kLongest = 40;
  if (word.size() > kLongest) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : allowed) {
    const std::size_t distance = edit_distance(lower(word), candidate);
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

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
  fail(fmt::format("unknown {} {}; {}", what, json::shown(found),
                   meant
                       ? fmt::format("did you mean {}?", json::shown(*meant))
                       : fmt::format("{} {}", allowed.size() == 1 ? "expected" : "expected one of", listed(allowed))));
}

void Cursor::allow_keys(std::initializer_list<std::string_view> allowed) const {
  if (!is(Kind::kObject)) fail_expected("an object");
  for (std::size_t i = 0; i < node_->keys.size(); ++i) {
    if (std::find(allowed.begin(), allowed.end(), node_->keys[i]) == allowed.end()) {
      item(i).fail_unknown("key", node_->keys[i], {allowed.begin(), allowed.size()});
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
    fail(fmt::format("{} is out of range; expected {} to {}", json::number_text(node_->number),
                     json::number_text(least), json::number_text(most)));
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

}  // namespace morphkit::project
