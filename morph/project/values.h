#pragma once
// The parts of a project that may be spelled in several ways, read and built. Internal to morph/project.

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "morph/json/cursor.h"
#include "morph/project/project.h"

namespace morphkit::project {

inline constexpr std::pair<std::string_view, MethodName> kMethods[] = {{"lines", MethodName::kLines},
                                                                       {"mesh", MethodName::kMesh}};
inline constexpr std::pair<std::string_view, warp::MeshSpline> kMeshSplines[] = {
    {"monotone", warp::MeshSpline::kMonotone},
    {"catmull-rom", warp::MeshSpline::kCatmullRom},
    {"linear", warp::MeshSpline::kLinear}};
inline constexpr std::pair<std::string_view, warp::PassOrder> kPassOrders[] = {
    {"auto", warp::PassOrder::kAuto},
    {"rows-first", warp::PassOrder::kRowsFirst},
    {"columns-first", warp::PassOrder::kColumnsFirst}};
inline constexpr std::pair<std::string_view, warp::LineScale> kScales[] = {{"along", warp::LineScale::kAlong},
                                                                           {"uniform", warp::LineScale::kUniform}};
inline constexpr std::pair<std::string_view, Between> kBetweens[] = {{"endpoints", Between::kEndpoints},
                                                                     {"centre", Between::kCentre}};
inline constexpr std::pair<std::string_view, warp::FieldAccuracy> kFields[] = {
    {"adaptive", warp::FieldAccuracy::kAdaptive}, {"exact", warp::FieldAccuracy::kExact}};
inline constexpr std::pair<std::string_view, warp::Filter> kFilters[] = {
    {"nearest", warp::Filter::kNearest}, {"bilinear", warp::Filter::kBilinear}, {"bicubic", warp::Filter::kBicubic},
    {"area", warp::Filter::kArea},       {"mitchell", warp::Filter::kMitchell}, {"lanczos", warp::Filter::kLanczos}};
inline constexpr std::pair<std::string_view, std::optional<warp::Border>> kBorders[] = {
    {"auto", std::nullopt},
    {"transparent", warp::Border::kTransparent},
    {"clamp", warp::Border::kClamp},
    {"mirror", warp::Border::kMirror}};
inline constexpr std::pair<std::string_view, Blend> kBlends[] = {{"linear", Blend::kLinear},
                                                                 {"display", Blend::kDisplay}};
inline constexpr std::pair<std::string_view, Fit> kFits[] = {
    {"contain", Fit::kContain}, {"cover", Fit::kCover}, {"stretch", Fit::kStretch}, {"none", Fit::kNone}};
inline constexpr std::pair<std::string_view, motion::CurveKind> kCurves[] = {
    {"polyline", motion::CurveKind::kPolyline},
    {"catmull-rom", motion::CurveKind::kCatmullRom},
    {"bezier", motion::CurveKind::kBezier}};

/// The name of `value` in one of the tables above.
template <typename T, std::size_t N>
json::Node named(const std::pair<std::string_view, T> (&names)[N], const T& value) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return json::Node::string(std::string(name));
  }
  return json::Node::string(std::string(names[0].first));
}

/// The value that the cursor names in one of the tables above.
template <typename T, std::size_t N>
T choose(const json::Cursor& at, const std::string& what, const std::pair<std::string_view, T> (&names)[N]) {
  return at.choice<T>(what, names);
}

motion::Timing read_timing(const json::Cursor& at);
Rate read_fps(const json::Cursor& at);
Background read_background(const json::Cursor& at);

/// Builders: with `defaults`, everything that has a default is written too.
json::Node timing_node(const motion::Timing& timing, bool defaults);
json::Node fps_node(Rate rate);
json::Node background_node(const Background& background);

}  // namespace morphkit::project
