// Frame rates and backgrounds: several spellings, one value.

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "morph/project/codecs.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;

/// A background that is a picture.
struct BackgroundImage {
  std::filesystem::path image;
};

template <typename F>
void describe(F& form, Of<BackgroundImage>) {
  form("image", &BackgroundImage::image,
       {.what = "the path of an image", .needed = "name the picture that lies behind, e.g. {\"image\": \"sky.png\"}"},
       "path of the picture that lies behind");
}

Node pattern_schema(const char* pattern) {
  Node node = Node::object();
  node.set("type", Node::string("string"));
  node.set("pattern", Node::string(pattern));
  return node;
}

constexpr const char* kFpsForms = "a frame rate such as 24, 29.97 or \"30000/1001\"";

/// The NTSC family as people write it; exactly n * 1000 / 1001.
constexpr std::pair<double, int> kDecimalRates[] = {{23.976, 24}, {23.98, 24}, {29.97, 30},
                                                    {47.952, 48}, {59.94, 60}, {119.88, 120}};

std::optional<Rate> named_rate(double decimal) {
  for (const auto& [name, rounded] : kDecimalRates)
    if (name == decimal) return Rate{rounded * 1000, 1001};
  return std::nullopt;
}

std::optional<int> parse_term(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > kMaxFpsTerm) return {};
  return value;
}

std::optional<Rate> parse_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto num = parse_term(text.substr(0, slash));
  const auto den = slash == std::string_view::npos ? 1 : parse_term(text.substr(slash + 1));
  if (!num || !den) return std::nullopt;
  return Rate{*num, *den};
}

bool too_fast(Rate rate) {
  return rate.num > rate.den * static_cast<long long>(kMaxFps);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

constexpr double kByte = 255;

std::optional<Color> parse_hex(const std::string& text) {
  if (text.empty() || text[0] != '#' || (text.size() != 7 && text.size() != 9)) return {};
  double channels[4] = {0, 0, 0, 1};
  for (std::size_t i = 1; i < text.size(); i += 2) {
    const int high = hex_digit(text[i]), low = hex_digit(text[i + 1]);
    if (high < 0 || low < 0) return {};
    channels[i / 2] = (high * 16 + low) / kByte;
  }
  return Color{channels[0], channels[1], channels[2], channels[3]};
}

Color read_color(const json::Cursor& at) {
  if (at.is(Kind::kArray)) {
    at.expect_array(3, 4, "a colour [r, g, b] or [r, g, b, a]");
    return {at.item(0).number(0, 1), at.item(1).number(0, 1), at.item(2).number(0, 1),
            at.size() == 4 ? at.item(3).number(0, 1) : 1};
  }
  const std::string& text = at.string();
  if (text == "transparent") return {0, 0, 0, 0};
  if (text == "black") return {0, 0, 0, 1};
  if (text == "white") return {1, 1, 1, 1};
  const auto color = parse_hex(text);
  if (!color) at.fail_expected("a colour: \"#rrggbb\", \"#rrggbbaa\", \"transparent\", \"black\" or \"white\"");
  return *color;
}

/// "#rrggbb" or "#rrggbbaa" if that says exactly this colour.
std::optional<std::string> hex_text(const Color& color) {
  std::string text = "#";
  for (const double channel : {color.r, color.g, color.b, color.a}) {
    text += fmt::format("{:02x}", static_cast<int>(std::lround(std::clamp(channel, 0.0, 1.0) * kByte)));
  }
  if (parse_hex(text) != color) return {};
  return color.a == 1 ? text.substr(0, 7) : text;
}

}  // namespace

std::optional<Rate> parse_rate(const std::string& text) {
  double decimal = 0;
  const char* const end = text.data() + text.size();
  if (const auto read = std::from_chars(text.data(), end, decimal); read.ec == std::errc() && read.ptr == end)
    if (const auto rate = named_rate(decimal)) return rate;
  const auto rate = parse_fraction(text);
  return rate && !too_fast(*rate) ? rate : std::nullopt;
}

void Codec<Rate>::read(const json::Cursor& at, Rate& value, const Facts&) {
  if (at.is(Kind::kNumber)) {
    const double number = at.number();
    if (const auto rate = named_rate(number)) {
      value = *rate;
      return;
    }
    if (number != std::trunc(number)) at.fail_expected("a whole number or a fraction such as \"25/2\"");
    value = {at.integer(1, kMaxFps), 1};
    return;
  }
  if (!at.is(Kind::kString)) at.fail_expected(kFpsForms);
  const auto rate = parse_fraction(at.string());
  if (!rate) at.fail_expected(kFpsForms);
  if (too_fast(*rate)) at.fail_expected(fmt::format("at most {} frames per second", kMaxFps));
  value = *rate;
}

Node Codec<Rate>::write(const Rate& value, const Facts&, bool) {
  if (value.den == 1) return Node::of_number(value.num);
  return Node::string(fmt::format("{}/{}", value.num, value.den));
}

Node Codec<Rate>::schema(const Facts&) {
  Node decimals = Node::array(), decimal = Node::object(), any = Node::array(), node = Node::object();
  for (const auto& entry : kDecimalRates) decimals.push(Node::of_number(entry.first));
  decimal.set("enum", std::move(decimals));
  any.push(number_schema("integer", 1, kMaxFps));
  any.push(std::move(decimal));
  any.push(pattern_schema("^[0-9]{1,7}(/[0-9]{1,7})?$"));
  node.set("anyOf", std::move(any));
  return node;
}

void Codec<Background>::read(const json::Cursor& at, Background& value, const Facts&) {
  if (at.is(Kind::kObject)) {
    BackgroundImage image;
    read_object(at, image, kWhole<BackgroundImage>);
    value = image.image;
    return;
  }
  if (!at.is(Kind::kString) && !at.is(Kind::kArray)) {
    at.fail_expected("a colour such as \"#204060\", \"transparent\", or {\"image\": \"sky.png\"}");
  }
  value = read_color(at);
}

Node Codec<Background>::write(const Background& value, const Facts&, bool defaults) {
  if (const auto* path = std::get_if<std::filesystem::path>(&value)) {
    return write_object(BackgroundImage{*path}, {}, defaults);
  }
  const Color& color = std::get<Color>(value);
  if (color == Color{}) return Node::string("transparent");
  if (const auto hex = hex_text(color)) return Node::string(*hex);
  Node node = Node::array();
  for (const double channel : {color.r, color.g, color.b}) node.push(Node::of_number(channel));
  if (color.a != 1) node.push(Node::of_number(color.a));
  return node;
}

Node Codec<Background>::schema(const Facts&) {
  static constexpr std::string_view kNames[] = {"transparent", "black", "white"};
  Node any = Node::array(), node = Node::object();
  any.push(strings_schema(kNames));
  any.push(pattern_schema("^#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"));
  any.push(array_schema(number_schema("number", 0, 1), false, 3, 4));
  any.push(object_schema<BackgroundImage>());
  node.set("anyOf", std::move(any));
  return node;
}

}  // namespace morphkit::project
