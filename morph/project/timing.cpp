// Easing names and their parameters.

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "morph/project/limits.h"
#include "morph/project/values.h"

namespace morphkit::project {
namespace {

using json::Kind;
using json::Node;
using motion::CubicBezierEase;
using motion::Easing;
using motion::KeysEase;

/// An easing with its default parameters by name; the last four are those of CSS (css-easing-1, section 2.2).
const std::pair<std::string_view, Easing> kEasings[] = {{"linear", motion::LinearEase{}},
                                                        {"sine", motion::SineEase{}},
                                                        {"sinusoidal", motion::SinusoidalEase{}},
                                                        {"parabolic", motion::ParabolicEase{}},
                                                        {"cubic-bezier", CubicBezierEase{}},
                                                        {"step", motion::StepEase{}},
                                                        {"keys", KeysEase{}},
                                                        {"ease", CubicBezierEase{0.25, 0.1, 0.25, 1}},
                                                        {"ease-in", CubicBezierEase{0.42, 0, 1, 1}},
                                                        {"ease-out", CubicBezierEase{0, 0, 0.58, 1}},
                                                        {"ease-in-out", CubicBezierEase{0.42, 0, 0.58, 1}}};

// A delay and a duration that add up to 1 in decimals may exceed it by a rounding error in binary.
constexpr double kRounding = 1e-9;

void set_number(const json::Cursor& at, std::string_view key, double least, double most, double& value) {
  if (const auto found = at.find(key)) value = found->number(least, most);
}

KeysEase::Key read_key(const json::Cursor& at) {
  at.expect_array(2, 3, "a key [time, progress] or [time, progress, speed]");
  KeysEase::Key key{at.item(0).number(0, 1), at.item(1).number(-kMaxCoordinate, kMaxCoordinate), std::nullopt};
  if (at.size() == 3) key.speed = at.item(2).number(-kMaxCoordinate, kMaxCoordinate);
  return key;
}

/// Overrides the default parameters of `easing` by those that `at` gives; refuses the parameters of other easings.
void read_parameters(const json::Cursor& at, const std::string& name, Easing& easing) {
  if (auto* sinusoidal = std::get_if<motion::SinusoidalEase>(&easing)) {
    at.allow_keys({"ease", "delay", "duration", "k1", "k2"});
    set_number(at, "k1", 0, 1, sinusoidal->k1);
    set_number(at, "k2", 0, 1, sinusoidal->k2);
  } else if (auto* parabolic = std::get_if<motion::ParabolicEase>(&easing)) {
    at.allow_keys({"ease", "delay", "duration", "t1", "t2"});
    set_number(at, "t1", 0, 1, parabolic->t1);
    set_number(at, "t2", 0, 1, parabolic->t2);
  } else if (auto* bezier = std::get_if<CubicBezierEase>(&easing); bezier && name == "cubic-bezier") {
    at.allow_keys({"ease", "delay", "duration", "handles"});
    if (const auto handles = at.find("handles")) {
      handles->expect_array(4, 4, "four numbers [x1, y1, x2, y2]");
      *bezier = {handles->item(0).number(0, 1), handles->item(1).number(-kMaxCoordinate, kMaxCoordinate),
                 handles->item(2).number(0, 1), handles->item(3).number(-kMaxCoordinate, kMaxCoordinate)};
    }
  } else if (auto* step = std::get_if<motion::StepEase>(&easing)) {
    at.allow_keys({"ease", "delay", "duration", "at"});
    set_number(at, "at", 0, 1, step->at);
  } else if (auto* keyed = std::get_if<KeysEase>(&easing)) {
    at.allow_keys({"ease", "delay", "duration", "keys"});
    const json::Cursor keys =
        at.require("keys", "the easing \"keys\" wants its keys, e.g. [[0, 0], [0.4, 0.9], [1, 1]]");
    keys.expect_array(2, kMaxPoints, fmt::format("an array of 2 to {} keys", kMaxPoints));
    for (std::size_t i = 0; i < keys.size(); ++i) keyed->keys.push_back(read_key(keys.item(i)));
  } else {
    at.allow_keys({"ease", "delay", "duration"});
  }
  if (const auto problem = motion::problem(easing)) at.fail(*problem);
}

Easing read_easing_name(const json::Cursor& at) {
  return choose(at, "easing", kEasings);
}

Node number_array(std::initializer_list<double> values) {
  Node node = Node::array();
  for (const double value : values) node.push(Node::of_number(value));
  return node;
}

Node key_node(const KeysEase::Key& key) {
  Node node = number_array({key.t, key.s});
  if (key.speed) node.push(Node::of_number(*key.speed));
  return node;
}

/// The shortest name: a CSS one if the handles are its, else that of the kind.
std::string easing_name(const Easing& easing) {
  for (auto it = std::rbegin(kEasings); it != std::rend(kEasings); ++it) {
    const bool generic = it->first == "cubic-bezier";
    if (!generic && std::holds_alternative<CubicBezierEase>(it->second) && it->second == easing) {
      return std::string(it->first);
    }
  }
  for (const auto& [name, candidate] : kEasings) {
    if (candidate.index() == easing.index()) return std::string(name);
  }
  return "linear";
}

/// Adds the parameters; without `defaults` only those that differ.
void add_parameters(Node& node, const Easing& easing, bool defaults) {
  const auto add = [&](const char* key, double value, double usual) {
    if (defaults || value != usual) node.set(key, Node::of_number(value));
  };
  if (const auto* sinusoidal = std::get_if<motion::SinusoidalEase>(&easing)) {
    add("k1", sinusoidal->k1, motion::SinusoidalEase{}.k1);
    add("k2", sinusoidal->k2, motion::SinusoidalEase{}.k2);
  } else if (const auto* parabolic = std::get_if<motion::ParabolicEase>(&easing)) {
    add("t1", parabolic->t1, motion::ParabolicEase{}.t1);
    add("t2", parabolic->t2, motion::ParabolicEase{}.t2);
  } else if (const auto* bezier = std::get_if<CubicBezierEase>(&easing)) {
    if (easing_name(easing) == "cubic-bezier") {
      node.set("handles", number_array({bezier->x1, bezier->y1, bezier->x2, bezier->y2}));
    }
  } else if (const auto* step = std::get_if<motion::StepEase>(&easing)) {
    add("at", step->at, motion::StepEase{}.at);
  } else if (const auto* keyed = std::get_if<KeysEase>(&easing)) {
    Node keys = Node::array();
    for (const auto& key : keyed->keys) keys.push(key_node(key));
    node.set("keys", std::move(keys));
  }
}

}  // namespace

motion::Timing read_timing(const json::Cursor& at) {
  motion::Timing timing;
  if (at.is(Kind::kString)) {
    timing.easing = read_easing_name(at);
    if (std::holds_alternative<KeysEase>(timing.easing)) {
      at.fail(R"(the easing "keys" wants its keys: {"ease": "keys", "keys": [[0, 0], [0.4, 0.9], [1, 1]]})");
    }
    return timing;
  }
  if (!at.is(Kind::kObject)) at.fail_expected("the name of an easing or an object {\"ease\": ...}");
  std::string name = "linear";
  if (const auto ease = at.find("ease")) {
    timing.easing = read_easing_name(*ease);
    name = ease->string();
  }
  read_parameters(at, name, timing.easing);
  set_number(at, "delay", 0, 1, timing.delay);
  timing.duration = 1 - timing.delay;
  set_number(at, "duration", 0, 1, timing.duration);
  if (timing.delay + timing.duration > 1 + kRounding) {
    at.fail(fmt::format("delay and duration add up to {}: it would not be finished at the end; expected at most 1",
                        json::number_text(timing.delay + timing.duration)));
  }
  return timing;
}

json::Node timing_node(const motion::Timing& timing, bool defaults) {
  Node node = Node::object();
  node.set("ease", Node::string(easing_name(timing.easing)));
  add_parameters(node, timing.easing, defaults);
  if (defaults || timing.delay != 0) node.set("delay", Node::of_number(timing.delay));
  if (defaults || timing.duration != 1 - timing.delay) node.set("duration", Node::of_number(timing.duration));
  const bool name_says_all = node.items.size() == 1;
  return name_says_all ? node.items.front() : node;
}

}  // namespace morphkit::project
