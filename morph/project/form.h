#pragma once
// The form of the document: what a key is called, what it may hold and what it means, said once.
// `describe(form, Of<T>{})` says it for the struct T, one line per key. Visitors are the forms that it is called with:
// form_read.h, form_write.h, form_schema.h, form_values.h. Internal to morph/project.

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "morph/json/cursor.h"
#include "morph/json/json.h"

namespace morphkit::project {

/// Names a struct for `describe`.
template <typename T>
struct Of {};

/// What the form says of a key beside its name, its member and its sentence. Each kind of value uses what concerns it.
struct Facts {
  double least = -std::numeric_limits<double>::infinity();  ///< number: its range; list: its number of items
  double most = std::numeric_limits<double>::infinity();
  bool whole = false;                            ///< an inherited number without decimals
  double usual = 0;                              ///< an inherited number: its default at the end of the chain
  std::string_view what = {};                    ///< how messages call the value; empty: as the key
  std::string_view needed = {};                  ///< not empty: the key must be there; the end of that message
  std::string_view otherwise = {};               ///< the default in words, where it is not a value
  std::span<const std::string_view> words = {};  ///< a string that is one of these
  bool identity = false;                         ///< items of a list are known by this key
  bool expand = false;                           ///< one key per line
};

/// How values of type T stand in JSON:
///   static void read(const json::Cursor&, T&, const Facts&);
///   static json::Node write(const T&, const Facts&, bool defaults);
///   static json::Node schema(const Facts&);
/// and, where a value has several spellings, `static constexpr bool kSpellings = true`.
template <typename T>
struct Codec;

/// What visitors have in common: the plain call, `form("a", &Pull::a, {...}, "...")`, finds the codec by the type of
/// the member; `form.as(codec, ...)` names it.
/// @param access  a pointer to a member, or a function that gives the value of its owner.
template <typename Self, typename Owner>
class Form {
 public:
  template <typename Access>
  using Member = std::remove_cvref_t<std::invoke_result_t<const Access&, Owner&>>;

  template <typename Access>
  void operator()(std::string_view name, const Access& access, const Facts& facts, std::string_view sentence) {
    self().template key<Codec<Member<Access>>>(name, access, facts, sentence);
  }
  template <typename AnyCodec, typename Access>
  void as(AnyCodec, std::string_view name, const Access& access, const Facts& facts, std::string_view sentence) {
    self().template key<AnyCodec>(name, access, facts, sentence);
  }

 private:
  Self& self() { return static_cast<Self&>(*this); }
};

/// A visitor that does nothing. The full list of the calls that a `describe` may make.
template <typename Owner>
class NoForm : public Form<NoForm<Owner>, Owner> {
 public:
  /// One key.
  template <typename AnyCodec, typename Access>
  void key(std::string_view, const Access&, const Facts&, std::string_view) {}
  /// The keys of a member, among those of its owner.
  template <typename Access>
  void part(const Access&) {}
  /// A key whose object holds members of the owner. @param body  body(form) describes them.
  template <typename Body>
  void object(std::string_view, std::string_view, const Body&) {}
  /// A key that says which alternative a variant holds; exactly one of these keys stands in an object.
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view, const Access&, std::string_view, const Body&) {}
};

template <typename T>
concept Described = requires(NoForm<T>& form) {
  describe(form, Of<T>{});
};

/// The names of the keys, in order.
template <typename Owner>
class KeyNames : public Form<KeyNames<Owner>, Owner> {
 public:
  explicit KeyNames(std::vector<std::string_view>& names) : names_(names) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access&, const Facts&, std::string_view) {
    names_.push_back(name);
  }
  template <typename Access>
  void part(const Access&) {
    using Part = typename KeyNames::template Member<Access>;
    KeyNames<Part> inner(names_);
    describe(inner, Of<Part>{});
  }
  template <typename Body>
  void object(std::string_view name, std::string_view, const Body&) {
    names_.push_back(name);
  }
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view name, const Access&, std::string_view, const Body&) {
    names_.push_back(name);
  }

 private:
  std::vector<std::string_view>& names_;
};

/// The key by which items of a list are known; empty if there is none.
template <typename Owner>
class IdentityKey : public Form<IdentityKey<Owner>, Owner> {
 public:
  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access&, const Facts& facts, std::string_view) {
    if (facts.identity) name_ = name;
  }
  template <typename Access>
  void part(const Access&) {}
  template <typename Body>
  void object(std::string_view, std::string_view, const Body&) {}
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view, const Access&, std::string_view, const Body&) {}

  std::string_view name() const noexcept { return name_; }

 private:
  std::string_view name_;
};

/// Describes all of T.
template <typename T>
inline constexpr auto kWhole = [](auto& form) { describe(form, Of<T>{}); };

}  // namespace morphkit::project
