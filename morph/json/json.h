#pragma once
// JSON text as a tree that remembers order and where everything stood. The one source that
// includes nlohmann-json is json.cpp.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace morphkit::json {

// What a text may hold at most: far beyond any real project, close enough to keep hostile files cheap.
inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxDepth = 32;
inline constexpr std::size_t kMaxValues = 4'000'000;

enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject };

class Cursor;

/// One value. Objects keep the order of their keys; a key occurs once.
struct Node {
  Kind kind = Kind::kNull;
  bool boolean = false;
  double number = 0;
  std::string text;               ///< kString
  std::vector<std::string> keys;  ///< kObject: one per item
  std::vector<Node> items;        ///< kArray, kObject

  /// Where the value stands in the text that it came from (`locate`), [begin, end); its key begins at key_begin.
  std::size_t key_begin = 0, begin = 0, end = 0;
  /// The text at [begin, end) no longer tells this value: it must be written anew.
  bool fresh = true;
  /// Laid out one item per line, however short.
  bool expand = false;
  /// An array laid out with so many items on each line, however long; 0: as many as fit.
  std::size_t per_line = 0;
  /// The key that tells the items of this array apart (`merge`); empty: their position does.
  std::string_view identity = {};
  /// Whether two spellings mean the same value (`merge`); null: if they are equal.
  bool (*same)(const Cursor&, const Cursor&) = nullptr;
  /// A located container of the original text whose spacing this one imitates; must outlive it.
  const Node* model = nullptr;

  static Node string(std::string value);
  static Node of_number(double value);
  static Node of_bool(bool value);
  static Node array();
  static Node object();

  bool is(Kind other) const noexcept { return kind == other; }
  bool is_container() const noexcept { return kind == Kind::kArray || kind == Kind::kObject; }
  const Node* find(std::string_view key) const noexcept;  ///< the value of `key`, or nullptr
  void set(std::string key, Node value);                  ///< appends; @pre !find(key)
  void push(Node value) { items.push_back(std::move(value)); }
};

/// Equal values; the order of keys and the spelling of numbers do not count.
bool same_value(const Node& a, const Node& b);

/// @param text  UTF-8 without a byte order mark (see `strip_bom`).
/// @param file  name for messages.
/// @throws Error kBadInput: syntax errors with line and column, repeated keys, nesting, too many values and numbers
///         beyond double with a JSON pointer.
Node parse(const std::string& text, const std::string& file);

/// Removes a UTF-8 byte order mark; explains other encodings. @throws Error kBadInput.
std::string strip_bom(std::string text, const std::string& file);

/// Fills key_begin, begin, end and clears `fresh` in the tree that `parse` made of `text`.
void locate(Node& root, const std::string& text);

/// `root` as text. Values that are not fresh are copied from `original`; fresh containers imitate the spacing of
/// their model; what has none is laid out two spaces deep, on one line where 120 columns allow.
std::string write(const Node& root, const std::string& original);

/// Shortest text that reads back as `value`. @throws std::invalid_argument if it is not finite.
std::string number_text(double value);

/// `value` as a JSON string. @throws Error kBadInput if it is not UTF-8.
std::string quote(std::string_view value);

/// For messages: in double quotes, cut short, without control characters.
std::string shown(std::string_view value);

/// JSON pointer (RFC 6901) of a key: "/" and the key with ~ and / escaped.
std::string pointer_token(std::string_view key);

}  // namespace morphkit::json
