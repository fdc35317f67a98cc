// Frame rates and backgrounds: several spellings, one value.

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "morph/project/limits.h"
#include "morph/project/values.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;

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

Rate read_fps(const json::Cursor& at) {
  if (at.is(Kind::kNumber)) {
    const double value = at.node().number;
    if (const auto rate = named_rate(value)) return *rate;
    if (value != std::trunc(value)) at.fail_expected("a whole number or a fraction such as \"25/2\"");
    return {at.integer(1, kMaxFps), 1};
  }
  if (!at.is(Kind::kString)) at.fail_expected(kFpsForms);
  const auto rate = parse_fraction(at.string());
  if (!rate) at.fail_expected(kFpsForms);
  if (too_fast(*rate)) at.fail_expected(fmt::format("at most {} frames per second", kMaxFps));
  return *rate;
}

Background read_background(const json::Cursor& at) {
  if (at.is(Kind::kObject)) {
    at.allow_keys({"image"});
    const json::Cursor image = at.require("image", "name the picture that lies behind, e.g. {\"image\": \"sky.png\"}");
    return std::filesystem::path(image.name("the path of an image"));
  }
  if (!at.is(Kind::kString) && !at.is(Kind::kArray)) {
    at.fail_expected("a colour such as \"#204060\", \"transparent\", or {\"image\": \"sky.png\"}");
  }
  return read_color(at);
}

json::Node fps_node(Rate rate) {
  if (rate.den == 1) return Node::of_number(rate.num);
  return Node::string(fmt::format("{}/{}", rate.num, rate.den));
}

json::Node background_node(const Background& background) {
  if (const auto* path = std::get_if<std::filesystem::path>(&background)) {
    Node node = Node::object();
    node.set("image", Node::string(path->string()));
    return node;
  }
  const Color& color = std::get<Color>(background);
  if (color == Color{}) return Node::string("transparent");
  if (const auto hex = hex_text(color)) return Node::string(*hex);
  Node node = Node::array();
  for (const double channel : {color.r, color.g, color.b}) node.push(Node::of_number(channel));
  if (color.a != 1) node.push(Node::of_number(color.a));
  return node;
}

}  // namespace morphkit::project
