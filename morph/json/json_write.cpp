// Writes a tree as text and changes as little as possible of the original text.

#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "base/error.h"
#include "morph/json/json.h"

namespace morphkit::json {
namespace {

constexpr std::size_t kColumns = 120;
constexpr std::size_t kIndent = 2;

/// Bytes of the UTF-8 sequence at the start of `text`, or 0 if it is malformed (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return tail(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool overlong = first == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = first == 0xED && byte(1) > 0x9F;
    return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool overlong = first == 0xF0 && byte(1) < 0x90;
    const bool beyond = first == 0xF4 && byte(1) > 0x8F;
    return tail(1) && tail(2) && tail(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

/// Walks valid JSON text together with its tree.
class Locator {
 public:
  explicit Locator(const std::string& text, std::size_t position = 0) : text_(text), position_(position) {}

  void value(Node& node) {
    space();
    node.begin = node.key_begin = place();
    node.fresh = false;
    if (node.is(Kind::kString)) {
      string();
    } else if (node.is_flat()) {
      brackets();
    } else if (node.is_container()) {
      container(node);
    } else {
      position_ = text_.find_first_of(" \t\r\n,]}", position_);
      if (position_ == std::string::npos) position_ = text_.size();
    }
    node.end = place();
  }

 private:
  void space() { position_ = text_.find_first_not_of(" \t\r\n", position_); }

  void string() {
    ++position_;
    while (text_[position_] != '"') position_ += text_[position_] == '\\' ? 2 : 1;
    ++position_;
  }

  /// A flat array: numbers and the brackets around them.
  void brackets() {
    std::size_t depth = 0;
    do {
      position_ = text_.find_first_of("[]", position_);
      text_[position_++] == '[' ? ++depth : --depth;
    } while (depth > 0);
  }

  void container(Node& node) {
    ++position_;
    for (Node& item : node.mutable_items()) {
      space();
      const std::uint32_t key_begin = place();
      if (node.is(Kind::kObject)) {
        string();
        space();
        ++position_;  // the colon
      }
      value(item);
      if (node.is(Kind::kObject)) item.key_begin = key_begin;
      space();
      if (text_[position_] == ',') ++position_;
    }
    space();
    ++position_;  // the closing bracket
  }

  std::uint32_t place() const { return static_cast<std::uint32_t>(position_); }

  const std::string& text_;
  std::size_t position_;
};

class Writer {
 public:
  explicit Writer(const std::string& original) : original_(original) {}

  /// @param indent  of the line where the value starts.
  /// @param column  where it starts on that line.
  std::string value(const Node& node, std::size_t indent, std::size_t column) const {
    if (!node.fresh) return spliced(node);
    if (!node.is_container()) return scalar(node);
    if (node.size() == 0) return node.is(Kind::kArray) ? "[]" : "{}";
    const Hints& hints = node.hints();
    if (hints.model && hints.model->size() > 0) return imitated(node, indent);
    if (!hints.expand && hints.per_line == 0) {
      std::string line = on_line(node);
      if (column + line.size() < kColumns && line.find('\n') == std::string::npos) return line;
    }
    return expanded(node, indent);
  }

 private:
  std::string piece(std::size_t begin, std::size_t end) const { return original_.substr(begin, end - begin); }

  static std::string scalar(const Node& node) {
    switch (node.kind()) {
      case Kind::kBool:
        return node.boolean() ? "true" : "false";
      case Kind::kNumber:
        return number_text(node.number());
      case Kind::kString:
        return quote(node.text());
      default:
        return "null";
    }
  }

  /// The original text with the new texts of the items in their old places.
  std::string spliced(const Node& node) const {
    std::string result;
    std::size_t position = node.begin;
    for (const Node& item : node.items()) {
      result += piece(position, item.begin);
      // Finding the start of the line costs its length, so this is done only where something is laid out anew.
      const bool laid_out = item.fresh && item.is_container();
      result += laid_out ? value(item, indent_at(item.begin), column_at(item.begin)) : value(item, 0, 0);
      position = item.end;
    }
    return result + piece(position, node.end);
  }

  /// Items joined with the spacing that the container had before its items changed.
  std::string imitated(const Node& node, std::size_t indent) const {
    const Node& model = *node.hints().model;
    const std::vector<Node>& before = model.items();
    const std::string lead = piece(model.begin + 1, before.front().key_begin);
    const std::string tail = piece(before.back().end, model.end - 1);
    const std::string separator =
        before.size() > 1 ? piece(before[0].end, before[1].key_begin) : "," + (lead.empty() ? " " : lead);
    const std::size_t newline = lead.rfind('\n');
    const std::size_t inner = newline == std::string::npos ? indent : lead.size() - newline - 1;
    std::string result = (node.is(Kind::kArray) ? "[" : "{") + lead;
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i > 0) result += separator;
      const std::string key = key_text(node, i);
      result += key + item_value(node, i, inner, inner + key.size());
    }
    return result + tail + (node.is(Kind::kArray) ? "]" : "}");
  }

  std::string key_text(const Node& node, std::size_t i) const {
    if (node.is(Kind::kArray)) return "";
    const Node& item = node.items()[i];
    // An item with a place in the original keeps the spelling of its key and the spacing after it.
    return item.end > 0 ? piece(item.key_begin, item.begin) : quote(node.keys()[i]) + ": ";
  }

  std::string on_line(const Node& node) const {
    if (!node.fresh || !node.is_container()) return value(node, 0, 0);
    std::string result = node.is(Kind::kArray) ? "[" : "{";
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i > 0) result += ", ";
      if (node.is(Kind::kObject)) result += quote(node.keys()[i]) + ": ";
      result += item_on_line(node, i);
    }
    return result + (node.is(Kind::kArray) ? "]" : "}");
  }

  std::string item_on_line(const Node& node, std::size_t i) const {
    return node.is_flat() ? flat_item(node.flat(), i) : on_line(node.items()[i]);
  }

  static std::string flat_item(const Flat& flat, std::size_t i) {
    if (flat.row == 0) return number_text(flat.numbers[i]);
    std::string result;
    for (std::size_t k = 0; k < flat.row; ++k) {
      result += k == 0 ? "[" : ", ";
      result += number_text(flat.numbers[i * flat.row + k]);
    }
    return result + "]";
  }

  std::string item_value(const Node& node, std::size_t i, std::size_t indent, std::size_t column) const {
    return node.is_flat() ? flat_item(node.flat(), i) : value(node.items()[i], indent, column);
  }

  std::string expanded(const Node& node, std::size_t indent) const {
    const std::string start = std::string(1, '\n').append(indent + kIndent, ' ');
    const std::string end = std::string(1, '\n').append(indent, ' ');
    const bool is_object = node.is(Kind::kObject);
    if (!is_object && !node.hints().expand) return "[" + start + filled(node, start) + end + "]";
    std::string result = is_object ? "{" : "[";
    for (std::size_t i = 0; i < node.size(); ++i) {
      const std::string key = is_object ? quote(node.keys()[i]) + ": " : "";
      if (i > 0) result += ',';
      result += start;
      result += key;
      result += item_value(node, i, indent + kIndent, indent + kIndent + key.size());
    }
    return result + end + (is_object ? "}" : "]");
  }

  /// As many items on a line as requested, or as fit: rows of a mesh, long lists of points.
  std::string filled(const Node& node, const std::string& start) const {
    std::string result;
    std::size_t column = start.size() - 1;
    const std::size_t per_line = node.hints().per_line;
    for (std::size_t i = 0; i < node.size(); ++i) {
      const std::string item = item_on_line(node, i);
      if (i > 0) {
        const bool fits = per_line > 0 ? i % per_line != 0 : column + item.size() + 3 <= kColumns;
        result += fits ? ", " : "," + start;
        column = fits ? column + 2 : start.size() - 1;
      }
      result += item;
      column += item.size();
    }
    return result;
  }

  std::size_t line_begin(std::size_t position) const {
    const std::size_t newline = position == 0 ? std::string::npos : original_.rfind('\n', position - 1);
    return newline == std::string::npos ? 0 : newline + 1;
  }
  std::size_t column_at(std::size_t position) const { return position - line_begin(position); }
  std::size_t indent_at(std::size_t position) const {
    const std::size_t begin = line_begin(position);
    return original_.find_first_not_of(" \t", begin) - begin;
  }

  const std::string& original_;
};

}  // namespace

std::string number_text(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a project holds a number that is not finite");
  constexpr double kExactInteger = 9007199254740992.0;  // 2^53
  if (std::abs(value) <= kExactInteger && value == std::trunc(value)) {
    return std::to_string(static_cast<long long>(value));
  }
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

std::string quote(std::string_view value) {
  std::string result = "\"";
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = utf8_length(value.substr(i));
    if (length == 0) {
      throw Error(ErrorKind::kBadInput, "", fmt::format("{} is not UTF-8, so a project cannot name it", shown(value)));
    }
    const char c = value[i];
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      result += value.substr(i, length);
    }
    i += length;
  }
  return result + "\"";
}

void locate(Node& root, const std::string& text) {
  Locator(text).value(root);
}

void locate_items(Node& node, const std::string& text) {
  if (!node.is_flat()) return;
  const std::uint32_t key_begin = node.key_begin;
  node.mutable_items();
  Locator(text, node.begin).value(node);
  node.key_begin = key_begin;
}

std::string write(const Node& root, const std::string& original) {
  std::string text = Writer(original).value(root, 0, 0);
  if (!root.fresh) return original.substr(0, root.begin) + text + original.substr(root.end);
  return text + "\n";
}

}  // namespace morphkit::json
