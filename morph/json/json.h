#pragma once
// JSON text as a tree that remembers order and where everything stood. The one source that
// includes nlohmann-json is json.cpp.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "morph/json/box.h"

namespace morphkit::json {

// What a text may hold at most: far beyond any real project, close enough to keep hostile files cheap.
inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxDepth = 32;
inline constexpr std::size_t kMaxValues = 10'000'000;
inline constexpr std::size_t kMaxNodes = 4'000'000;  ///< of these, what does not lie in a flat array

enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject };

class Cursor;
class Node;

/// How a value is to be written and merged, where that is not told by the value.
struct Hints {
  /// Laid out one item per line, however short.
  bool expand = false;
  /// An array laid out with so many items on each line, however long; 0: as many as fit.
  std::size_t per_line = 0;
  /// The key that tells the items of this array apart (`merge`); empty: their position does.
  std::string_view identity = {};
  /// Whether two spellings mean the same value (`merge`); null: if they are equal.
  bool (*same)(const Cursor&, const Cursor&) = nullptr;
  /// A located container of the original text whose spacing this one imitates; must outlive it. It is not flat.
  const Node* model = nullptr;
};

/// An array of numbers, or of rows of `row` numbers each, in one block: 8 bytes per number.
struct Flat {
  std::vector<double> numbers;
  std::size_t row = 0;  ///< 0: the items are the numbers

  std::size_t size() const noexcept { return row == 0 ? numbers.size() : numbers.size() / row; }
  bool operator==(const Flat&) const = default;
};

/// One value, in 40 bytes and what is out of line. Objects keep the order of their keys; a key occurs once. An array is
/// flat as long as all that was pushed are numbers, or rows of as many numbers; meshes and lists of points are. Other
/// arrays hold a node per item.
class Node {
 public:
  /// Where the value stands in the text that it came from (`locate`), [begin, end); its key begins at key_begin.
  std::uint32_t key_begin = 0, begin = 0, end = 0;
  /// The text at [begin, end) no longer tells this value: it must be written anew.
  bool fresh = true;

  Node() = default;  ///< null
  static Node string(std::string value) { return Node(Value(Box<std::string>(std::move(value)))); }
  static Node of_number(double value) { return Node(Value(value)); }
  static Node of_bool(bool value) { return Node(Value(value)); }
  static Node array() { return Node(Value(Box<Flat>(Flat{}))); }
  static Node object() { return Node(Value(Box<Members>(Members{}))); }

  Kind kind() const noexcept { return kKinds[value_.index()]; }
  bool is(Kind other) const noexcept { return kind() == other; }
  bool is_container() const noexcept { return is(Kind::kArray) || is(Kind::kObject); }
  bool is_flat() const noexcept { return std::holds_alternative<Box<Flat>>(value_); }

  // The value. @pre it is of that kind; the text of other kinds is empty.
  bool boolean() const { return std::get<bool>(value_); }
  double number() const { return std::get<double>(value_); }
  const std::string& text() const noexcept;
  const Flat& flat() const { return *std::get<Box<Flat>>(value_); }

  // Containers; anything else has no items and no keys.
  std::size_t size() const noexcept { return is_flat() ? flat().size() : items().size(); }
  const std::vector<std::string>& keys() const noexcept;  ///< kObject: one per item
  const std::vector<Node>& items() const noexcept;        ///< of an object, or of an array that is not flat
  /// Of an object or an array. A flat array becomes one that is not.
  std::vector<Node>& mutable_items();
  const Node* find(std::string_view key) const noexcept;  ///< the value of `key`, or nullptr
  Node* find(std::string_view key) noexcept;
  void set(std::string key, Node value) { insert(size(), std::move(key), std::move(value)); }  ///< @pre !find(key)
  void insert(std::size_t place, std::string key, Node value);
  void push(Node value);  ///< to an array
  /// Pushes a number or a row of numbers if the array stays flat with it; false, and nothing happens, if not.
  bool absorb(const Node& value);
  void clear() noexcept;  ///< Empties a flat array, which keeps its memory.

  const Hints& hints() const noexcept;
  Hints& mutable_hints();

 private:
  struct Members {
    std::vector<std::string> keys;
    std::vector<Node> items;
  };
  using Value =
      std::variant<std::monostate, bool, double, Box<std::string>, Box<Flat>, Box<std::vector<Node>>, Box<Members>>;

  bool stays_flat(const Node& value) const noexcept;

  static constexpr Kind kKinds[] = {Kind::kNull,  Kind::kBool,  Kind::kNumber, Kind::kString,
                                    Kind::kArray, Kind::kArray, Kind::kObject};
  static_assert(std::size(kKinds) == std::variant_size_v<Value>);

  explicit Node(Value value) : value_(std::move(value)) {}

  Value value_;
  Box<Hints> hints_;
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

/// Fills key_begin, begin, end and clears `fresh` in the tree that `parse` made of `text`. What lies in a flat array
/// has no place of its own.
void locate(Node& root, const std::string& text);

/// Makes a located flat array of `text` one that is not, and gives its items their places; other nodes stay.
void locate_items(Node& node, const std::string& text);

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
