#pragma once
// The choices of the document and the words for them: one table per choice, for files, options, reports and widgets.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "morph/project/project.h"

namespace morphkit::project {

template <typename T>
using Word = std::pair<std::string_view, T>;

/// The words for the values of T, `Words<T>::kTable`. Specialised for each choice.
template <typename T>
struct Words;

template <>
struct Words<MethodName> {
  static constexpr auto kTable = []<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    return std::to_array<Word<MethodName>>(
        {{std::variant_alternative_t<kIndex, Method>::kName, static_cast<MethodName>(kIndex)}...});
  }
  (std::make_index_sequence<std::variant_size_v<Method>>());
};

template <>
struct Words<warp::MeshSpline> {
  static constexpr auto kTable = std::to_array<Word<warp::MeshSpline>>({{"monotone", warp::MeshSpline::kMonotone},
                                                                        {"catmull-rom", warp::MeshSpline::kCatmullRom},
                                                                        {"linear", warp::MeshSpline::kLinear}});
};

template <>
struct Words<warp::PassOrder> {
  static constexpr auto kTable =
      std::to_array<Word<warp::PassOrder>>({{"auto", warp::PassOrder::kAuto},
                                            {"rows-first", warp::PassOrder::kRowsFirst},
                                            {"columns-first", warp::PassOrder::kColumnsFirst}});
};

template <>
struct Words<warp::LineScale> {
  static constexpr auto kTable = std::to_array<Word<warp::LineScale>>(
      {{"along", warp::LineScale::kAlong}, {"uniform", warp::LineScale::kUniform}});
};

template <>
struct Words<Between> {
  static constexpr auto kTable =
      std::to_array<Word<Between>>({{"endpoints", Between::kEndpoints}, {"centre", Between::kCentre}});
};

template <>
struct Words<warp::FieldAccuracy> {
  static constexpr auto kTable = std::to_array<Word<warp::FieldAccuracy>>(
      {{"adaptive", warp::FieldAccuracy::kAdaptive}, {"exact", warp::FieldAccuracy::kExact}});
};

template <>
struct Words<warp::Filter> {
  static constexpr auto kTable = std::to_array<Word<warp::Filter>>({{"nearest", warp::Filter::kNearest},
                                                                    {"bilinear", warp::Filter::kBilinear},
                                                                    {"bicubic", warp::Filter::kBicubic},
                                                                    {"area", warp::Filter::kArea},
                                                                    {"mitchell", warp::Filter::kMitchell},
                                                                    {"lanczos", warp::Filter::kLanczos}});
};

template <>
struct Words<Blend> {
  static constexpr auto kTable = std::to_array<Word<Blend>>({{"linear", Blend::kLinear}, {"display", Blend::kDisplay}});
};

template <>
struct Words<Fit> {
  static constexpr auto kTable = std::to_array<Word<Fit>>(
      {{"contain", Fit::kContain}, {"cover", Fit::kCover}, {"stretch", Fit::kStretch}, {"none", Fit::kNone}});
};

template <>
struct Words<motion::CurveKind> {
  static constexpr auto kTable =
      std::to_array<Word<motion::CurveKind>>({{"polyline", motion::CurveKind::kPolyline},
                                              {"catmull-rom", motion::CurveKind::kCatmullRom},
                                              {"bezier", motion::CurveKind::kBezier}});
};

template <>
struct Words<std::optional<warp::Border>> {
  static constexpr auto kTable =
      std::to_array<Word<std::optional<warp::Border>>>({{"auto", std::nullopt},
                                                        {"transparent", warp::Border::kTransparent},
                                                        {"clamp", warp::Border::kClamp},
                                                        {"mirror", warp::Border::kMirror}});
};

/// An easing with its default parameters by name; the last four are the names of CSS (css-easing-1, section 2.2).
template <>
struct Words<motion::Easing> {
  static const std::array<Word<motion::Easing>, 11> kTable;
};

template <typename T>
concept Worded = requires {
  Words<T>::kTable;
};

/// The word for a value of a choice; of an easing, whatever its parameters, the shortest name. "" if there is none.
template <Worded T>
constexpr std::string_view word_of(const T& value) {
  for (const auto& [word, candidate] : Words<T>::kTable) {
    if (candidate == value) return word;
  }
  return {};
}
std::string_view word_of(const motion::Easing& easing);

}  // namespace morphkit::project
