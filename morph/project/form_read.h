#pragma once
// Visitors that read: an object's keys into a struct. Keys that the form does not describe are refused.
// Internal to morph/project.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "morph/project/form.h"

namespace morphkit::project {

/// Reads the keys of the object at `at` into `value`; missing keys leave their members unchanged.
/// @param demanding  whether a missing required key is an error.
template <typename Owner>
class Reader : public Form<Reader<Owner>, Owner> {
 public:
  Reader(const json::Cursor& at, Owner& value, bool demanding = true) : at_(at), value_(value), demanding_(demanding) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts& facts, std::string_view) {
    if (const auto found = at_.find(name)) {
      Facts named = facts;
      if (named.what.empty()) named.what = name;
      AnyCodec::read(*found, std::invoke(access, value_), named);
    } else if (demanding_ && !facts.needed.empty()) {
      at_.require(name, std::string(facts.needed));
    }
  }
  template <typename Access>
  void part(const Access& access) {
    using Part = typename Reader::template Member<Access>;
    Reader<Part> inner(at_, std::invoke(access, value_), demanding_);
    describe(inner, Of<Part>{});
  }
  template <typename Body>
  void object(std::string_view name, std::string_view, const Body& body);
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view name, const Access& access, std::string_view, const Body& body);

 private:
  json::Cursor at_;
  Owner& value_;
  bool demanding_;
};

/// Reads an object whose keys `body` describes. @throws Error kBadInput.
template <typename Owner, typename Body>
void read_object(const json::Cursor& at, Owner& value, const Body& body, bool demanding = true) {
  static const std::vector<std::string_view> kNames = [&] {
    std::vector<std::string_view> names;
    KeyNames<Owner> collector(names);
    body(collector);
    return names;
  }();
  at.allow_keys(kNames);
  Reader<Owner> reader(at, value, demanding);
  body(reader);
}

template <typename Owner>
template <typename Body>
void Reader<Owner>::object(std::string_view name, std::string_view, const Body& body) {
  if (const auto found = at_.find(name)) read_object(*found, value_, body);
}

template <typename Owner>
template <typename T, typename Access, typename Body>
void Reader<Owner>::alternative(Of<T>, std::string_view name, const Access& access, std::string_view,
                                const Body& body) {
  const auto found = at_.find(name);
  if (!found) return;
  std::invoke(access, value_) = T{};
  read_object(*found, value_, body);
}

}  // namespace morphkit::project
