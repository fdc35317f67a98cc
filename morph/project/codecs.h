#pragma once
// How the kinds of values stand in JSON: numbers, words, names, places, lists, structs. Internal to morph/project.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core/types.hpp>

#include "morph/project/checks.h"
#include "morph/project/form.h"
#include "morph/project/form_read.h"
#include "morph/project/form_schema.h"
#include "morph/project/form_write.h"
#include "morph/project/limits.h"
#include "morph/project/project.h"
#include "morph/project/words.h"

namespace morphkit::project {

/// Pieces of a schema.
json::Node number_schema(const char* type, double least, double most);
json::Node strings_schema(std::span<const std::string_view> words);
/// @param items  one for all, or, if `tuple`, a list of one for each.
json::Node array_schema(json::Node items, bool tuple, double least, double most);
json::Node name_schema();

template <>
struct Codec<double> {
  static void read(const json::Cursor& at, double& value, const Facts& facts) {
    value = facts.whole ? at.integer(static_cast<int>(facts.least), static_cast<int>(facts.most))
                        : at.number(facts.least, facts.most);
  }
  static json::Node write(double value, const Facts&, bool) { return json::Node::of_number(value); }
  static json::Node schema(const Facts& facts) {
    return number_schema(facts.whole ? "integer" : "number", facts.least, facts.most);
  }
};

template <>
struct Codec<int> {
  static void read(const json::Cursor& at, int& value, const Facts& facts) {
    value = at.integer(static_cast<int>(facts.least), static_cast<int>(facts.most));
  }
  static json::Node write(int value, const Facts&, bool) { return json::Node::of_number(value); }
  static json::Node schema(const Facts& facts) { return number_schema("integer", facts.least, facts.most); }
};

template <>
struct Codec<bool> {
  static void read(const json::Cursor& at, bool& value, const Facts&) { value = at.boolean(); }
  static json::Node write(bool value, const Facts&, bool) { return json::Node::of_bool(value); }
  static json::Node schema(const Facts&);
};

/// A name, or one of the words of the form; empty: not given.
template <>
struct Codec<std::string> {
  static void read(const json::Cursor& at, std::string& value, const Facts& facts);
  static json::Node write(const std::string& value, const Facts&, bool) { return json::Node::string(value); }
  static json::Node schema(const Facts& facts);
};

template <>
struct Codec<std::filesystem::path> {
  static void read(const json::Cursor& at, std::filesystem::path& value, const Facts& facts) {
    value = at.path(std::string(facts.what));
  }
  static json::Node write(const std::filesystem::path& value, const Facts&, bool) {
    return json::Node::string(value.string());
  }
  static json::Node schema(const Facts&) { return name_schema(); }
};

/// One of a table of words.
template <Worded T>
struct Codec<T> {
  static constexpr bool kGiven = true;  // nothing is one of the words
  static void read(const json::Cursor& at, T& value, const Facts& facts) {
    value = at.choice<T>(std::string(facts.what), Words<T>::kTable);
  }
  static json::Node write(const T& value, const Facts&, bool) {
    return json::Node::string(std::string(word_of(value)));
  }
  static json::Node schema(const Facts&) {
    std::vector<std::string_view> words;
    words.reserve(std::size(Words<T>::kTable));
    for (const auto& entry : Words<T>::kTable) words.push_back(entry.first);
    return strings_schema(words);
  }
};

/// An optional value.
template <typename T>
requires(!Worded<std::optional<T>>) struct Codec<std::optional<T>> {
  static constexpr bool kSpellings = requires { Codec<T>::kSpellings; };
  static void read(const json::Cursor& at, std::optional<T>& value, const Facts& facts) {
    T inner{};
    Codec<T>::read(at, inner, facts);
    value = std::move(inner);
  }
  static json::Node write(const std::optional<T>& value, const Facts& facts, bool defaults) {
    return Codec<T>::write(*value, facts, defaults);
  }
  static json::Node schema(const Facts& facts) { return Codec<T>::schema(facts); }
  static json::Node default_node(const Facts& facts) {
    if constexpr (std::is_arithmetic_v<T>) {
      return json::Node::of_number(facts.usual);
    } else {
      return Codec<T>::write(T{}, facts, false);
    }
  }
  static void inner_rows(std::vector<std::string>& rows) requires Described<T> { collect_rows<T>(rows); }
};

/// An object of its own.
template <Described T>
struct Codec<T> {
  static void read(const json::Cursor& at, T& value, const Facts&) {
    read_object(at, value, kWhole<T>);
    if constexpr (requires { check(at, value); }) check(at, value);
  }
  static json::Node write(const T& value, const Facts&, bool defaults) {
    static const T kUsual{};
    return write_object(value, kUsual, defaults);
  }
  static json::Node schema(const Facts&) { return object_schema<T>(); }
  static void inner_rows(std::vector<std::string>& rows) { collect_rows<T>(rows); }
};

/// A list of objects.
template <Described T>
struct Codec<std::vector<T>> {
  static void read(const json::Cursor& at, std::vector<T>& value, const Facts& facts) {
    at.expect_array(0, kMaxFeatures, fmt::format("an array of at most {} {}", kMaxFeatures, facts.what));
    value.clear();
    value.reserve(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) Codec<T>::read(at.item(i), value.emplace_back(), {});
  }
  static json::Node write(const std::vector<T>& value, const Facts&, bool defaults) {
    static const std::string_view kIdentity = [] {
      IdentityKey<T> form;
      describe(form, Of<T>{});
      return form.name();
    }();
    json::Node node = json::Node::array();
    node.mutable_hints().expand = true;
    node.mutable_hints().identity = kIdentity;
    for (const T& item : value) node.push(Codec<T>::write(item, {}, defaults));
    return node;
  }
  static json::Node schema(const Facts&) { return array_schema(object_schema<T>(), false, 0, kMaxFeatures); }
  static void inner_rows(std::vector<std::string>& rows) { collect_rows<T>(rows); }
};

/// One place [x, y] if the form says 1, else a list of so many.
template <>
struct Codec<Points> {
  static void read(const json::Cursor& at, Points& value, const Facts& facts);
  static json::Node write(const Points& value, const Facts& facts, bool defaults);
  static json::Node schema(const Facts& facts);
};

template <>
struct Codec<cv::Size> {
  static void read(const json::Cursor& at, cv::Size& value, const Facts&);
  static json::Node write(const cv::Size& value, const Facts&, bool);
  static json::Node schema(const Facts&);
};

/// Vertices [column, row] of a mesh.
template <>
struct Codec<std::vector<cv::Point>> {
  static void read(const json::Cursor& at, std::vector<cv::Point>& value, const Facts&);
  static json::Node write(const std::vector<cv::Point>& value, const Facts&, bool);
  static json::Node schema(const Facts&);
};

template <>
struct Codec<Rate> {
  static constexpr bool kSpellings = true;
  static void read(const json::Cursor& at, Rate& value, const Facts&);
  static json::Node write(const Rate& value, const Facts&, bool);
  static json::Node schema(const Facts&);
};

template <>
struct Codec<Background> {
  static constexpr bool kSpellings = true;
  static void read(const json::Cursor& at, Background& value, const Facts&);
  static json::Node write(const Background& value, const Facts&, bool);
  static json::Node schema(const Facts&);
};

template <>
struct Codec<motion::Timing> {
  static constexpr bool kSpellings = true;
  static void read(const json::Cursor& at, motion::Timing& timing, const Facts&);
  static json::Node write(const motion::Timing& timing, const Facts&, bool defaults);
  static json::Node schema(const Facts&);
  static json::Node full_schema();  ///< `schema` refers to it
};

/// Rows of the reference page for what all timings have.
void timing_rows(std::vector<std::string>& rows);

/// The version of the form, 1. It is checked before everything else.
struct VersionCodec {
  static void read(const json::Cursor& at, const Project&, const Facts&);
  static json::Node write(const Project&, const Facts&, bool) { return json::Node::of_number(1); }
  static json::Node schema(const Facts&);
};

/// [columns, rows] of a mesh.
struct GridCodec {
  static void read(const json::Cursor& at, Mesh& mesh, const Facts&);
  static json::Node write(const Mesh& mesh, const Facts&, bool);
  static json::Node schema(const Facts&);
};

/// The vertices on one picture; "uniform" if there are none.
void read_vertices(const json::Cursor& at, Mesh& mesh, SideIndex side);
json::Node write_vertices(const Mesh& mesh, SideIndex side);
json::Node vertices_schema();

template <SideIndex kSide>
struct VerticesCodec {
  static void read(const json::Cursor& at, Mesh& mesh, const Facts&) { read_vertices(at, mesh, kSide); }
  static json::Node write(const Mesh& mesh, const Facts&, bool) { return write_vertices(mesh, kSide); }
  static json::Node schema(const Facts&) { return vertices_schema(); }
  static bool is_usual(const Mesh& mesh) { return mesh.vertices[kSide].empty(); }
};

}  // namespace morphkit::project
