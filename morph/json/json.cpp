#include "morph/json/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/words.h"

namespace morphkit::json {

namespace {

/// "file:line:column" of a byte; columns count code points from 1.
std::string text_place(const std::string& text, const std::string& file, std::size_t byte) {
  byte = std::min(byte, text.size());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
  const auto line = 1 + std::count(text.begin(), end, '\n');
  std::size_t begin = byte == 0 ? std::string::npos : text.rfind('\n', byte - 1);
  begin = begin == std::string::npos ? 0 : begin + 1;
  const auto column = 1 + std::count_if(text.begin() + static_cast<std::ptrdiff_t>(begin), end,
                                        [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return fmt::format("{}:{}:{}", file, line, column);
}

/// The letters and signs around a byte, in lower case.
std::string word_at(const std::string& text, std::size_t byte) {
  constexpr std::string_view kWord = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ+-";
  if (byte >= text.size() || kWord.find(text[byte]) == std::string_view::npos) return "";
  const std::size_t before = text.find_last_not_of(kWord, byte);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return lower(text.substr(begin, std::min<std::size_t>(text.find_first_not_of(kWord, byte) - begin, 20)));
}

/// The usual mistake when JSON is invalid at this byte.
std::string hint(const std::string& what, const std::string& text, std::size_t byte) {
  const auto says = [&](std::string_view part) { return what.find(part) != std::string::npos; };
  const char at = byte < text.size() ? text[byte] : ' ';
  const std::string word = word_at(text, byte);
  if (says("unexpected end of input") || says("missing closing quote"))
    return "the file ends too early; is it cut off?";
  if (says("UTF-8")) return "the text is not UTF-8 here; save the file as UTF-8";
  if (says("control character")) return "is a closing quote missing?";
  if (at == '/' || at == '#') return "JSON has no comments; remove it";
  if (at == '\'') return "strings and keys want double quotes";
  if (word.find("nan") != std::string::npos || word.find("inf") != std::string::npos) {
    return "JSON knows no NaN and no infinity; write a finite number";
  }
  if (says("unexpected ']'") || says("unexpected '}'")) return "is there a comma before the closing bracket?";
  if (says("expected end of input")) return "the document has ended already";
  if (says("expected '}'") || says("expected ']'")) return "is a comma missing before this?";
  if (says("expected string literal") || says("parsing object key")) return "keys want double quotes";
  return "see the JSON syntax at json.org";
}

/// Builds the tree and refuses things that a plain parser accepts: repeated keys, endless nesting, too many values.
class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  Node take() { return std::move(root_); }

  bool null() override { return attach({}); }
  bool boolean(bool value) override { return attach(Node::of_bool(value)); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override { return attach(Node::string(std::move(value))); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Node::object()); }
  bool start_array(std::size_t) override { return open(next_array()); }
  bool end_array() override { return close(); }
  bool end_object() override {
    refuse_repeated_keys();
    return close();
  }
  bool key(string_t& value) override {
    open_.back().key = std::move(value);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) {
      fail(next_pointer(), fmt::format("the number {} is too large", shown(last_token)));
    }
    const std::string what = error.what();
    const std::size_t dash = what.find(" - ");
    const std::string reason =
        dash == std::string::npos ? "syntax error" : what.substr(dash + 3, what.find(';', dash) - dash - 3);
    const std::size_t byte = position == 0 ? 0 : position - 1;  // the parser counts from 1
    throw Error(ErrorKind::kBadInput, text_place(text_, file_, byte),
                fmt::format("not valid JSON: {}; {}", reason, hint(what, text_, byte)));
  }

 private:
  /// A container whose end is still to come, and the key of its next value.
  struct Open {
    Node node;
    std::string key;
  };

  bool number(double value) { return attach(Node::of_number(value)); }

  bool attach(Node node) {
    count_value();
    return put(std::move(node));
  }

  bool open(Node node) {
    if (open_.size() >= kMaxDepth) {
      fail(open_pointer(), fmt::format("nested more than {} deep; a project never is", kMaxDepth));
    }
    count_value();
    open_.push_back({std::move(node), {}});
    return true;
  }

  bool close() {
    Node node = std::move(open_.back().node);
    open_.pop_back();
    return put(std::move(node));
  }

  /// Puts a whole value into the container around it.
  bool put(Node node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return true;
    }
    auto& [parent, key] = open_.back();
    if (parent.is(Kind::kObject)) {
      count_nodes(1);
      parent.set(std::move(key), std::move(node));
    } else if (!parent.absorb(node)) {
      count_nodes(parent.is_flat() ? parent.size() + 1 : 1);
      parent.mutable_items().push_back(std::move(node));
    } else if (node.is(Kind::kArray)) {
      spare_ = std::move(node);
    }
    return true;
  }

  /// An empty array. Rows of numbers leave their memory to the next row.
  Node next_array() {
    if (!spare_.is(Kind::kArray)) return Node::array();
    spare_.clear();
    return std::exchange(spare_, {});
  }

  void count_value() {
    if (++values_ > kMaxValues) fail("", fmt::format("more than {} values; this is no project", kMaxValues));
  }
  void count_nodes(std::size_t more) {
    nodes_ += more;
    if (nodes_ > kMaxNodes) {
      fail("", fmt::format("more than {} values outside of lists of numbers; this is no project", kMaxNodes));
    }
  }

  void refuse_repeated_keys() const {
    const Node& object = open_.back().node;
    std::vector<std::string_view> keys(object.keys().begin(), object.keys().end());
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice == keys.end()) return;
    fail(open_pointer() + pointer_token(*twice),
         fmt::format("the key {} occurs twice here; remove one", shown(*twice)));
  }

  std::string pointer(std::size_t levels) const {
    std::string result;
    for (std::size_t i = 0; i < levels; ++i) {
      const auto& [node, key] = open_[i];
      result += node.is(Kind::kObject) ? pointer_token(key) : fmt::format("/{}", node.size());
    }
    return result;
  }
  /// The pointer of the innermost open container, or of the next value in it.
  std::string open_pointer() const { return open_.empty() ? "" : pointer(open_.size() - 1); }
  std::string next_pointer() const { return pointer(open_.size()); }

  [[noreturn]] void fail(const std::string& pointer, const std::string& message) const {
    throw Error(ErrorKind::kBadInput, pointer.empty() ? file_ : file_ + ": " + pointer, message);
  }

  const std::string& text_;
  const std::string& file_;
  Node root_, spare_;
  std::vector<Open> open_;
  std::size_t values_ = 0, nodes_ = 0;
};

}  // namespace

Node parse(const std::string& text, const std::string& file) {
  // The parser treats a zero byte as the end of the text and would ignore the rest.
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
    throw Error(ErrorKind::kBadInput, text_place(text, file, zero), "a zero byte; this is not a text file");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw Error(ErrorKind::kBadInput, file, "the file is empty; a project starts with {\"morphkit\": 1, ...}");
  }
  TreeBuilder builder(text, file);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

std::string strip_bom(std::string text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF")) return text.substr(3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw Error(ErrorKind::kBadInput, file, "the file is UTF-16; save it as UTF-8");
  }
  return text;
}

std::string shown(std::string_view value) {
  constexpr std::size_t kLongest = 48;
  const bool cut = value.size() > kLongest;
  value = value.substr(0, kLongest);
  // Do not cut a character in two.
  while (cut && !value.empty() && (static_cast<unsigned char>(value.back()) & 0xC0) == 0x80) value.remove_suffix(1);
  if (cut && !value.empty() && static_cast<unsigned char>(value.back()) >= 0xC0) value.remove_suffix(1);
  std::string result = "\"";
  for (const char c : value) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  return result + (cut ? "...\"" : "\"");
}

std::string pointer_token(std::string_view key) {
  constexpr std::size_t kLongest = 100;
  std::string result = "/";
  for (const char c : key.substr(0, kLongest)) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return result;
}

}  // namespace morphkit::json
