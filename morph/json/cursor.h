#pragma once
// Reading a JSON tree with types, ranges and messages that name the place.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "morph/json/json.h"

namespace morphkit::json {

/// A tree and the name that messages give it.
struct Document {
  std::string file;
  Node root;
};

/// One value of a document. Cheap to copy; valid while the document is. Its JSON pointer is found only when a message
/// needs it.
class Cursor {
 public:
  explicit Cursor(const Document& document) : Cursor(document, document.root) {}
  Cursor(const Document& document, const Node& node) : document_(&document), node_(&node) {}

  bool is(Kind kind) const noexcept { return kind == this->kind(); }
  std::string pointer() const;

  /// @throws Error kBadInput "file: pointer: message".
  [[noreturn]] void fail(const std::string& message) const;
  /// "expected <what>, found <this>".
  [[noreturn]] void fail_expected(std::string_view what) const;

  // Objects.
  /// Refuses keys that are not `allowed`, with the nearest one that is.
  void allow_keys(std::span<const std::string_view> allowed) const;
  std::optional<Cursor> find(std::string_view key) const;
  /// @param why  the end of "<key> is missing: ...".
  Cursor require(std::string_view key, const std::string& why) const;

  // Arrays.
  /// @param what  names what is expected, for the message.
  void expect_array(std::size_t least, std::size_t most, std::string_view what) const;
  std::size_t size() const noexcept { return level_ == Level::kNode ? node_->size() : node_->flat().row; }
  Cursor item(std::size_t i) const;

  // Scalars.
  double number() const;
  double number(double least, double most) const;
  int integer(int least, int most) const;
  bool boolean() const;
  const std::string& string() const;
  /// An id: not empty and without control characters.
  const std::string& name(const std::string& what) const;
  /// The path of a file: not empty and without NUL. Other control characters are allowed, as in a file system.
  const std::string& path(const std::string& what) const;

  template <typename T>
  using Names = std::span<const std::pair<std::string_view, T>>;
  /// One of the named values. @param what  names the choice, e.g. "filter".
  template <typename T>
  T choice(const std::string& what, Names<T> names) const {
    const std::string& text = string();
    for (const auto& [name, value] : names) {
      if (name == text) return value;
    }
    std::vector<std::string_view> allowed;
    for (const auto& entry : names) allowed.push_back(entry.first);
    fail_unknown(what, text, allowed);
  }

 private:
  /// What of its node the cursor stands for: in a flat array, rows and numbers are not nodes.
  enum class Level : std::uint8_t { kNode, kRow, kNumber };

  Cursor(const Cursor& array, Level level, std::size_t first)
      : document_(array.document_), node_(array.node_), first_(first), level_(level) {}

  Kind kind() const noexcept {
    if (level_ == Level::kNode) return node_->kind();
    return level_ == Level::kRow ? Kind::kArray : Kind::kNumber;
  }
  std::string description() const;
  [[noreturn]] void fail_unknown(const std::string& what, std::string_view found,
                                 std::span<const std::string_view> allowed) const;

  const Document* document_;
  const Node* node_;
  std::size_t first_ = 0;  ///< of the flat array: the number, or the first one of the row
  Level level_ = Level::kNode;
};

}  // namespace morphkit::json
