#pragma once
// Visitors that write: a struct's keys into an object. Internal to morph/project.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "morph/project/form.h"

namespace morphkit::project {

/// Whether a value is not given: then nothing is written, even if all defaults are wanted.
template <typename T>
bool is_nothing(const T&) {
  return false;
}
template <typename T>
bool is_nothing(const std::optional<T>& value) {
  return !value;
}
inline bool is_nothing(const std::string& value) {
  return value.empty();
}

template <typename AnyCodec>
concept Spelled = requires {
  requires AnyCodec::kSpellings;
};

/// Whether two texts of a value that has several spellings mean the same.
template <typename AnyCodec, typename T>
bool same_spelled(const json::Cursor& a, const json::Cursor& b) {
  T first{}, second{};
  AnyCodec::read(a, first, {});
  AnyCodec::read(b, second, {});
  return first == second;
}

/// Builds an object key by key; what equals `usual` is left out unless `defaults` are wanted.
template <typename Owner>
class Writer : public Form<Writer<Owner>, const Owner> {
 public:
  Writer(const Owner& value, const Owner& usual, bool defaults, json::Node& node)
      : value_(value), usual_(usual), defaults_(defaults), node_(node) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts& facts, std::string_view) {
    const auto& value = std::invoke(access, value_);
    if constexpr (!requires { AnyCodec::kGiven; }) {
      if (is_nothing(value)) return;
    }
    if (!defaults_ && facts.needed.empty() && is_usual<AnyCodec>(value, access)) return;
    json::Node node = AnyCodec::write(value, facts, defaults_);
    const bool says_nothing = node.is(json::Kind::kObject) && node.size() == 0;
    if (says_nothing && !defaults_ && facts.needed.empty()) return;
    if (facts.expand) node.mutable_hints().expand = true;
    using T = std::remove_const_t<typename Writer::template Member<Access>>;
    if constexpr (Spelled<AnyCodec>) node.mutable_hints().same = &same_spelled<AnyCodec, T>;
    node_.set(std::string(name), std::move(node));
  }
  template <typename Access>
  void part(const Access& access) {
    using Part = std::remove_const_t<typename Writer::template Member<Access>>;
    Writer<Part> inner(std::invoke(access, value_), std::invoke(access, usual_), defaults_, node_);
    describe(inner, Of<Part>{});
  }
  template <typename Body>
  void object(std::string_view name, std::string_view, const Body& body) {
    json::Node node = json::Node::object();
    Writer<Owner> inner(value_, usual_, defaults_, node);
    body(inner);
    if (defaults_ || node.size() > 0) node_.set(std::string(name), std::move(node));
  }
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view name, const Access& access, std::string_view, const Body& body) {
    if (!std::holds_alternative<T>(std::invoke(access, value_))) return;
    Owner usual;
    std::invoke(access, usual) = T{};
    json::Node node = json::Node::object();
    Writer<Owner> inner(value_, usual, defaults_, node);
    body(inner);
    node_.set(std::string(name), std::move(node));
  }

 private:
  template <typename AnyCodec, typename T, typename Access>
  bool is_usual(const T& value, const Access& access) const {
    if constexpr (requires { AnyCodec::is_usual(value); }) {
      return AnyCodec::is_usual(value);
    } else if constexpr (Described<T>) {
      return false;  // told by its keys
    } else {
      return value == std::invoke(access, usual_);
    }
  }

  const Owner& value_;
  const Owner& usual_;
  bool defaults_;
  json::Node& node_;
};

template <typename T>
json::Node write_object(const T& value, const T& usual, bool defaults) {
  json::Node node = json::Node::object();
  Writer<T> writer(value, usual, defaults, node);
  describe(writer, Of<T>{});
  return node;
}

}  // namespace morphkit::project
