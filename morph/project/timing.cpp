// Timings: the name of an easing, or an object with its parameters.

#include <initializer_list>

#include "morph/project/codecs.h"
#include "morph/project/describe.h"

namespace morphkit::project {

using json::Kind;
using json::Node;
using motion::CubicBezierEase;
using motion::Easing;
using motion::KeysEase;
using motion::Timing;

const std::array<Word<Easing>, 11> Words<Easing>::kTable = {{{"linear", motion::LinearEase{}},
                                                             {"sine", motion::SineEase{}},
                                                             {"sinusoidal", motion::SinusoidalEase{}},
                                                             {"parabolic", motion::ParabolicEase{}},
                                                             {"cubic-bezier", CubicBezierEase{}},
                                                             {"step", motion::StepEase{}},
                                                             {"keys", KeysEase{}},
                                                             {"ease", CubicBezierEase{0.25, 0.1, 0.25, 1}},
                                                             {"ease-in", CubicBezierEase{0.42, 0, 1, 1}},
                                                             {"ease-out", CubicBezierEase{0, 0, 0.58, 1}},
                                                             {"ease-in-out", CubicBezierEase{0.42, 0, 0.58, 1}}}};

std::string_view word_of(const Easing& easing) {
  const auto& table = Words<Easing>::kTable;
  for (auto it = table.rbegin(); it != table.rend(); ++it) {
    const bool generic = it->first == "cubic-bezier";
    if (!generic && std::holds_alternative<CubicBezierEase>(it->second) && it->second == easing) return it->first;
  }
  for (const auto& [word, candidate] : table) {
    if (candidate.index() == easing.index()) return word;
  }
  return table.front().first;
}

namespace {

// A delay and a duration that add up to 1 in decimals may exceed it by a rounding error in binary.
constexpr double kRounding = 1e-9;

Node number_array(std::initializer_list<double> values) {
  Node node = Node::array();
  for (const double value : values) node.push(Node::of_number(value));
  return node;
}

Node fraction_schema() {
  return number_schema("number", 0, 1);
}

Node coordinate_schema() {
  return number_schema("number", -kMaxCoordinate, kMaxCoordinate);
}

/// [x1, y1, x2, y2]
struct HandlesCodec {
  static void read(const json::Cursor& at, CubicBezierEase& value, const Facts&) {
    at.expect_array(4, 4, "four numbers [x1, y1, x2, y2]");
    value = {at.item(0).number(0, 1), at.item(1).number(-kMaxCoordinate, kMaxCoordinate), at.item(2).number(0, 1),
             at.item(3).number(-kMaxCoordinate, kMaxCoordinate)};
  }
  static Node write(const CubicBezierEase& value, const Facts&, bool) {
    return number_array({value.x1, value.y1, value.x2, value.y2});
  }
  static Node schema(const Facts&) {
    Node items = Node::array();
    for (int i = 0; i < 2; ++i) {
      items.push(fraction_schema());
      items.push(coordinate_schema());
    }
    return array_schema(std::move(items), true, 4, 4);
  }
  static bool is_usual(const CubicBezierEase&) { return false; }
};

/// [time, progress] or [time, progress, speed], two or more.
struct KeysCodec {
  static void read(const json::Cursor& at, std::vector<KeysEase::Key>& keys, const Facts&) {
    at.expect_array(2, kMaxPoints, fmt::format("an array of 2 to {} keys", kMaxPoints));
    keys.clear();
    for (std::size_t i = 0; i < at.size(); ++i) {
      const json::Cursor item = at.item(i);
      item.expect_array(2, 3, "a key [time, progress] or [time, progress, speed]");
      KeysEase::Key& key = keys.emplace_back();
      key.t = item.item(0).number(0, 1);
      key.s = item.item(1).number(-kMaxCoordinate, kMaxCoordinate);
      if (item.size() == 3) key.speed = item.item(2).number(-kMaxCoordinate, kMaxCoordinate);
    }
  }
  static Node write(const std::vector<KeysEase::Key>& keys, const Facts&, bool) {
    Node node = Node::array();
    for (const KeysEase::Key& key : keys) {
      Node item = number_array({key.t, key.s});
      if (key.speed) item.push(Node::of_number(*key.speed));
      node.push(std::move(item));
    }
    return node;
  }
  static Node schema(const Facts&) {
    Node items = Node::array();
    items.push(fraction_schema());
    items.push(coordinate_schema());
    items.push(coordinate_schema());
    return array_schema(array_schema(std::move(items), true, 2, 3), false, 2, kMaxPoints);
  }
};

}  // namespace

// The parameters of each easing.
template <typename F>
void describe(F&, Of<motion::LinearEase>) {}
template <typename F>
void describe(F&, Of<motion::SineEase>) {}
template <typename F>
void describe(F& form, Of<motion::SinusoidalEase>) {
  form("k1", &motion::SinusoidalEase::k1, {.least = 0, .most = 1}, "end of the ease-in");
  form("k2", &motion::SinusoidalEase::k2, {.least = 0, .most = 1}, "start of the ease-out");
}
template <typename F>
void describe(F& form, Of<motion::ParabolicEase>) {
  form("t1", &motion::ParabolicEase::t1, {.least = 0, .most = 1}, "end of the acceleration");
  form("t2", &motion::ParabolicEase::t2, {.least = 0, .most = 1}, "start of the deceleration");
}
template <typename F>
void describe(F& form, Of<CubicBezierEase>) {
  form.as(
      HandlesCodec{}, "handles", [](auto& easing) -> auto& { return easing; }, {}, "`[x1, y1, x2, y2]` as in CSS");
}
template <typename F>
void describe(F& form, Of<motion::StepEase>) {
  form("at", &motion::StepEase::at, {.least = 0, .most = 1}, "when it jumps");
}
template <typename F>
void describe(F& form, Of<KeysEase>) {
  form.as(KeysCodec{}, "keys", &KeysEase::keys,
          {.needed = "the easing \"keys\" wants its keys, e.g. [[0, 0], [0.4, 0.9], [1, 1]]"},
          "`[time, progress]` or `[time, progress, speed]`; times rise from 0 to 1");
}
/// Keys of all easings.
template <typename F>
void describe(F& form, Of<Timing>) {
  form("delay", &Timing::delay, {.least = 0, .most = 1},
       "time before the change starts, as a fraction of the transition");
  form("duration", &Timing::duration, {.least = 0, .most = 1, .otherwise = "the rest after the delay"},
       "time of the change, likewise; `delay` and `duration` add up to at most 1");
}

namespace {

/// Whether an easing of this name has parameters: the names of CSS stand for theirs.
template <typename Ease>
bool has_parameters(std::string_view word) {
  std::vector<std::string_view> names;
  KeyNames<Ease> collector(names);
  describe(collector, Of<Ease>{});
  return !names.empty() && (!std::is_same_v<Ease, CubicBezierEase> || word == "cubic-bezier");
}

void read_parameters(const json::Cursor& at, std::string_view word, Easing& easing) {
  std::vector<std::string_view> names = {"ease", "delay", "duration"};
  std::visit(
      [&]<typename Ease>(Ease& parameters) {
        if (!has_parameters<Ease>(word)) return at.allow_keys(names);
        KeyNames<Ease> collector(names);
        describe(collector, Of<Ease>{});
        at.allow_keys(names);
        Reader<Ease> reader(at, parameters);
        describe(reader, Of<Ease>{});
      },
      easing);
  if (const auto problem = motion::problem(easing)) at.fail(*problem);
}

/// The object {"ease": ...} with the parameters of one easing.
template <typename Ease>
Node parameters_schema(Node ease, bool must_name) {
  Node properties = Node::object(), required = Node::array(), node = Node::object();
  properties.set("ease", std::move(ease));
  if (must_name) required.push(Node::string("ease"));
  SchemaForm<Ease> own;
  if (must_name) {
    describe(own, Of<Ease>{});
    own.move_to(properties);
    for (const Node& name : own.required().items()) required.push(name);
  }
  SchemaForm<Timing> all;
  describe(all, Of<Timing>{});
  all.move_to(properties);
  node.set("type", Node::string("object"));
  if (must_name) node.set("required", std::move(required));
  node.set("additionalProperties", Node::of_bool(false));
  node.set("properties", std::move(properties));
  return node;
}

}  // namespace

void Codec<Timing>::read(const json::Cursor& at, Timing& timing, const Facts&) {
  timing = {};
  const Facts easing{.what = "easing"};
  if (at.is(Kind::kString)) {
    Codec<Easing>::read(at, timing.easing, easing);
    if (std::holds_alternative<KeysEase>(timing.easing)) {
      at.fail(R"(the easing "keys" wants its keys: {"ease": "keys", "keys": [[0, 0], [0.4, 0.9], [1, 1]]})");
    }
    return;
  }
  if (!at.is(Kind::kObject)) at.fail_expected("the name of an easing or an object {\"ease\": ...}");
  std::string word = "linear";
  if (const auto ease = at.find("ease")) {
    Codec<Easing>::read(*ease, timing.easing, easing);
    word = ease->string();
  }
  read_parameters(at, word, timing.easing);
  Reader<Timing> reader(at, timing);
  describe(reader, Of<Timing>{});
  if (!at.find("duration")) timing.duration = 1 - timing.delay;
  if (timing.delay + timing.duration > 1 + kRounding) {
    at.fail(fmt::format("delay and duration add up to {}: it would not be finished at the end; expected at most 1",
                        json::number_text(timing.delay + timing.duration)));
  }
}

Node Codec<Timing>::write(const Timing& timing, const Facts&, bool defaults) {
  const std::string_view word = word_of(timing.easing);
  Node node = Node::object();
  node.set("ease", Node::string(std::string(word)));
  std::visit(
      [&]<typename Ease>(const Ease& parameters) {
        if (!has_parameters<Ease>(word)) return;
        const Ease usual{};
        Writer<Ease> writer(parameters, usual, defaults, node);
        describe(writer, Of<Ease>{});
      },
      timing.easing);
  const Timing usual{timing.easing, 0, 1 - timing.delay};
  Writer<Timing> writer(timing, usual, defaults, node);
  describe(writer, Of<Timing>{});
  const bool name_says_all = node.size() == 1;
  return name_says_all ? node.items().front() : node;
}

Node Codec<Timing>::schema(const Facts&) {
  Node node = Node::object();
  node.set("$ref", Node::string("#/$defs/timing"));
  return node;
}

Node Codec<Timing>::full_schema() {
  Node any = Node::array(), node = Node::object();
  std::vector<std::string_view> names, plain;
  for (const auto& [word, easing] : Words<Easing>::kTable) {
    if (!std::holds_alternative<KeysEase>(easing)) names.push_back(word);
    std::visit(
        [&, word = word]<typename Ease>(const Ease&) {
          if (!has_parameters<Ease>(word)) return plain.push_back(word);
          Node ease = Node::object();
          ease.set("const", Node::string(std::string(word)));
          any.push(parameters_schema<Ease>(std::move(ease), true));
        },
        easing);
  }
  std::vector<Node>& items = any.mutable_items();
  items.insert(items.begin(), parameters_schema<motion::LinearEase>(strings_schema(plain), false));
  items.insert(items.begin(), strings_schema(names));
  any.mutable_hints().expand = true;
  node.set("anyOf", std::move(any));
  return node;
}

void timing_rows(std::vector<std::string>& rows) {
  collect_rows<Timing>(rows);
}

}  // namespace morphkit::project
