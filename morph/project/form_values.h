#pragma once
// Visitors over values alone: inheritance, comparison. Internal to morph/project.

#include <functional>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "morph/project/form.h"

namespace morphkit::project {

/// Fills what `nearer` leaves open by what `farther` says, or by the defaults of the form.
template <typename Owner>
class Inherit : public Form<Inherit<Owner>, Owner> {
 public:
  /// @param farther  nothing: the defaults.
  Inherit(Owner& nearer, const Owner* farther) : nearer_(nearer), farther_(farther) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view, const Access& access, const Facts& facts, std::string_view) {
    auto& value = std::invoke(access, nearer_);
    if (value) return;
    if (farther_) {
      value = std::invoke(access, *farther_);
      return;
    }
    using Inner = typename std::remove_cvref_t<decltype(value)>::value_type;
    if constexpr (std::is_arithmetic_v<Inner>) {
      value = static_cast<Inner>(facts.usual);
    } else {
      value = Inner{};
    }
  }

 private:
  Owner& nearer_;
  const Owner* farther_;
};

template <typename T>
T inherited(T nearer, const T& farther) {
  Inherit<T> form(nearer, &farther);
  describe(form, Of<T>{});
  return nearer;
}

template <typename T>
T with_defaults(T value) {
  Inherit<T> form(value, nullptr);
  describe(form, Of<T>{});
  return value;
}

/// The names of the keys with different values, in order.
template <typename Owner>
class Differing : public Form<Differing<Owner>, Owner> {
 public:
  Differing(const Owner& a, const Owner& b, std::vector<std::string_view>& names) : a_(a), b_(b), names_(names) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts&, std::string_view) {
    if (std::invoke(access, a_) != std::invoke(access, b_)) names_.push_back(name);
  }

 private:
  const Owner& a_;
  const Owner& b_;
  std::vector<std::string_view>& names_;
};

}  // namespace morphkit::project
