#pragma once
// Random valid projects for property tests.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "morph/project/project.h"

namespace morphkit::test {

class RandomProject {
 public:
  explicit RandomProject(unsigned seed) : random_(seed) {}

  project::Project make() {
    project::Project project;
    project.pictures = {picture("source"), picture("destination")};
    for (int i = integer(0, 3); i > 0; --i) project.groups.push_back({"group " + std::to_string(i), pull(), pace()});
    for (int i = integer(0, 6); i > 0; --i) project.features.push_back(feature(project, "f" + std::to_string(i)));
    if (coin()) project.mesh = mesh(project);
    project.warp = warp(project);
    project.pull = pull();
    project.pace = pace();
    project.blend = pick({project::Blend::kLinear, project::Blend::kDisplay});
    project.output = output();
    return project;
  }

  /// Changes one thing or a few.
  void change(project::Project& project) {
    switch (integer(0, 12)) {
      case 0:
        project.features.push_back(feature(project, "new " + std::to_string(random_())));
        break;
      case 1:
        if (!project.features.empty()) project.features.erase(project.features.begin() + index(project.features));
        break;
      case 2:
        if (!project.features.empty()) {
          project::Feature& changed = project.features[index(project.features)];
          changed = feature(project, changed.id);
        }
        break;
      case 3:
        if (!project.features.empty())
          project.features[index(project.features)].id = "renamed " + std::to_string(random_());
        break;
      case 4:
        std::shuffle(project.features.begin(), project.features.end(), random_);
        break;
      case 5:
        project.pull = pull();
        project.pace = pace();
        break;
      case 6:
        project.output = output();
        break;
      case 7:
        project.warp = warp(project);
        break;
      case 8:
        project.pictures[project::kSource] = picture("source");
        break;
      case 9:
        project.groups.push_back({"group " + std::to_string(random_()), pull(), pace()});
        break;
      case 10:
        project.mesh.reset();
        if (coin()) project.mesh = mesh(project);
        break;
      case 11:
        if (project.mesh && !project.mesh->vertices[project::kSource].empty()) {
          project.mesh->vertices[project::kSource][index(project.mesh->vertices[project::kSource])] = point();
        }
        break;
      default:
        if (project.mesh) project.mesh->groups = mesh_groups(project, *project.mesh);
        break;
    }
    agree(project);
  }

  bool coin() { return integer(0, 1) == 1; }
  int integer(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
  double real(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }

 private:
  template <typename T>
  T pick(std::initializer_list<T> values) {
    return values.begin()[integer(0, static_cast<int>(values.size()) - 1)];
  }
  template <typename T>
  int index(const std::vector<T>& values) {
    return integer(0, static_cast<int>(values.size()) - 1);
  }

  /// Whole numbers, halves and anything: all are written in the shortest way that reads back equal.
  double coordinate() {
    const double value = real(-1000, 5000);
    return pick({std::round(value), std::round(value * 2) / 2, value, value * 1e-9, 0.0});
  }
  cv::Point2d point() { return {coordinate(), coordinate()}; }

  project::Picture picture(const char* id) {
    return {id, pick<std::string>({"a.png", "../b c.exr", "/abs/\"quoted\".png", "b\xC3\xA4r.tif", "back\\slash"}),
            pick<std::string>({"", "srgb", "linear"})};
  }

  motion::Easing easing() {
    switch (integer(0, 8)) {
      case 0:
        return motion::LinearEase{};
      case 1:
        return motion::SineEase{};
      case 2:
        return motion::SinusoidalEase{real(0, 0.5), pick({0.7, real(0.5, 1)})};
      case 3:
        return motion::ParabolicEase{pick({0.3, real(0, 0.5)}), real(0.5, 1)};
      case 4:
        return motion::CubicBezierEase{real(0, 1), real(-2, 2), real(0, 1), real(-2, 2)};
      case 5:
        return motion::CubicBezierEase{0.42, 0, pick({1.0, 0.58}), 1};
      case 6:
        return motion::CubicBezierEase{};
      case 7:
        return motion::StepEase{pick({0.5, real(0, 1)})};
      default:
        break;
    }
    motion::KeysEase keys{
        {{0, real(0, 0.1), std::nullopt}, {real(0.1, 0.9), real(0.2, 0.8), std::nullopt}, {1, 1, 0.5}}};
    if (coin()) keys.keys[1].speed = real(0, 2);
    return keys;
  }

  motion::Timing timing() {
    motion::Timing timing{easing(), 0, 1};
    if (coin()) timing.delay = real(0, 1);
    timing.duration = coin() ? 1 - timing.delay : real(0, 1 - timing.delay);
    return timing;
  }

  project::Pull pull() {
    project::Pull pull;
    if (coin()) pull.a = real(0, 10);
    if (coin()) pull.b = integer(0, 8);
    if (coin()) pull.p = real(0, 1);
    if (coin()) pull.scale = pick({warp::LineScale::kAlong, warp::LineScale::kUniform});
    if (coin()) pull.between = pick({project::Between::kEndpoints, project::Between::kCentre});
    if (coin()) pull.turns = integer(-3, 3);
    return pull;
  }

  project::Pace pace() {
    project::Pace pace;
    if (coin()) pace.shape = timing();
    if (coin()) pace.dissolve = timing();
    return pace;
  }

  /// A walk whose ends differ, so that neither side of a curve closes by itself.
  std::vector<cv::Point2d> walk(int count) {
    std::vector<cv::Point2d> points;
    for (int i = 0; i < count; ++i) points.push_back({100.0 * i + real(0, 50), coordinate()});
    return points;
  }

  project::Feature feature(const project::Project& project, const std::string& id) {
    project::Feature feature;
    feature.id = id;
    if (!project.groups.empty() && coin()) feature.group = project.groups[index(project.groups)].id;
    feature.mark =
        pick({project::Mark(project::Line{}), project::Mark(project::Point{}), project::Mark(project::Curve{})});
    if (std::holds_alternative<project::Line>(feature.mark)) {
      feature.places[project::kSource] = walk(2);
      feature.places[project::kDestination] = walk(2);
    } else if (std::holds_alternative<project::Point>(feature.mark)) {
      feature.places[project::kSource] = {point()};
      feature.places[project::kDestination] = {point()};
    } else {
      project::Curve curve;
      curve.closed = coin();
      curve.kind = pick({motion::CurveKind::kPolyline, motion::CurveKind::kCatmullRom, motion::CurveKind::kBezier});
      const auto count = [&] {
        const int pieces = integer(1, 20);
        return curve.kind == motion::CurveKind::kBezier ? 3 * pieces + (curve.closed ? 0 : 1) : pieces + 2;
      };
      feature.places[project::kSource] = walk(count());
      feature.places[project::kDestination] = walk(count());
      feature.mark = curve;
    }
    if (coin()) feature.pull = pull();
    if (coin()) feature.pace = pace();
    return feature;
  }

  std::vector<cv::Point2d> vertices(const project::Mesh& mesh) {
    std::vector<cv::Point2d> result;
    for (int i = 0; i < mesh.columns * mesh.rows; ++i) result.push_back(point());
    return result;
  }

  /// Every vertex is in one of the groups or in none.
  std::vector<project::MeshGroup> mesh_groups(const project::Project& project, const project::Mesh& mesh) {
    std::vector<project::MeshGroup> result;
    for (const project::Group& group : project.groups) {
      if (coin()) result.push_back({group.id, {}});
    }
    for (int i = 0; i < mesh.columns * mesh.rows && !result.empty(); ++i) {
      if (coin()) result[index(result)].vertices.emplace_back(i % mesh.columns, i / mesh.columns);
    }
    std::shuffle(result.begin(), result.end(), random_);
    return result;
  }

  project::Mesh mesh(const project::Project& project) {
    project::Mesh mesh;
    mesh.columns = integer(2, 6);
    mesh.rows = integer(2, 6);
    if (coin()) mesh.vertices[project::kSource] = vertices(mesh);
    if (coin()) mesh.vertices[project::kDestination] = vertices(mesh);
    if (coin()) mesh.groups = mesh_groups(project, mesh);
    return mesh;
  }

  project::Warp warp(const project::Project& project) {
    project::Warp warp;
    if (coin()) warp.method = pick({project::MethodName::kLines, project::MethodName::kMesh});
    warp.of<project::MeshMethod>().spline =
        pick({warp::MeshSpline::kMonotone, warp::MeshSpline::kCatmullRom, warp::MeshSpline::kLinear});
    warp.of<project::MeshMethod>().order =
        pick({warp::PassOrder::kAuto, warp::PassOrder::kRowsFirst, warp::PassOrder::kColumnsFirst});
    warp.filter = pick({warp::Filter::kNearest, warp::Filter::kBilinear, warp::Filter::kBicubic, warp::Filter::kArea,
                        warp::Filter::kMitchell, warp::Filter::kLanczos});
    if (coin()) warp.border = pick({warp::Border::kTransparent, warp::Border::kClamp, warp::Border::kMirror});
    project::Project wanted = project;
    wanted.warp = warp;
    agree(wanted);
    return wanted.warp;
  }

  /// Makes the warp one that the loader accepts.
  static void agree(project::Project& project) {
    if (!project.mesh && project.warp.method == project::MethodName::kMesh) project.warp.method.reset();
    if (project::method_name_of(project) == project::MethodName::kMesh && project.warp.border == warp::Border::kMirror)
      project.warp.border.reset();
  }

  project::Output output() {
    project::Output output;
    if (coin()) output.size = cv::Size(integer(1, 5000), integer(1, 5000));
    output.fit = pick({project::Fit::kContain, project::Fit::kCover, project::Fit::kStretch, project::Fit::kNone});
    output.frames = pick({48, integer(1, 10'000'000)});
    output.start = pick({1, integer(0, 100'000)});
    if (coin()) output.fps = pick<project::Rate>({{25, 1}, {30000, 1001}, {48, 2}, {1, 7}});
    switch (integer(0, 3)) {
      case 0:
        output.background =
            project::Color{integer(0, 255) / 255.0, integer(0, 255) / 255.0, 0, pick({0.0, 1.0, 128 / 255.0})};
        break;
      case 1:
        output.background = project::Color{real(0, 1), real(0, 1), real(0, 1), pick({1.0, real(0, 1)})};
        break;
      case 2:
        output.background = std::filesystem::path("sky.png");
        break;
      default:
        break;
    }
    return output;
  }

  std::mt19937 random_;
};

}  // namespace morphkit::test
