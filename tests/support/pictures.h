#pragma once
// Pictures and projects in memory, for tests without files.

#include <cstring>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "morph/project/project.h"
#include "morph/render/renderer.h"

namespace morphkit::test {

/// Smooth colours with random detail; opaque unless `with_alpha`, values from below 0 to above 1 like an EXR's.
inline warp::Image random_image(cv::Size size, unsigned seed, bool with_alpha = false) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<float>(random()) / 4294967295.0f; };
  warp::Image image(size);
  for (warp::Pixel& pixel : image) {
    const float alpha = with_alpha ? unit() : 1.0f;
    pixel = {(unit() * 1.2f - 0.1f) * alpha, (unit() * 1.2f - 0.1f) * alpha, (unit() * 1.2f - 0.1f) * alpha, alpha};
  }
  return image;
}

inline render::Footage pictures(const warp::Image& source, const warp::Image& destination, bool with_alpha = false) {
  return {{render::in_memory(source, with_alpha), render::in_memory(destination, with_alpha)}, {}};
}

/// The frame at progress t.
inline warp::Image frame_at(const render::Renderer& renderer, double t) {
  return renderer.frame(renderer.clock().at(t));
}

inline project::Feature line(std::string id, warp::Line source, warp::Line destination) {
  project::Feature feature;
  feature.id = std::move(id);
  feature.places[project::kSource] = {source.p, source.q};
  feature.places[project::kDestination] = {destination.p, destination.q};
  return feature;
}

inline project::Feature point(std::string id, cv::Point2d source, cv::Point2d destination) {
  project::Feature feature;
  feature.id = std::move(id);
  feature.mark = project::Point{};
  feature.places[project::kSource] = {source};
  feature.places[project::kDestination] = {destination};
  return feature;
}

/// A project with a few lines, a point and a curve that fit pictures of about 96x64.
inline project::Project small_project() {
  project::Project project;
  project.features = {line("brow", {{20, 14}, {70, 12}}, {{24, 18}, {66, 17}}),
                      line("side", {{10, 20}, {14, 52}}, {{16, 22}, {13, 50}}), point("nose", {48, 34}, {52, 31})};
  project::Feature curve;
  curve.id = "mouth";
  curve.mark = project::Curve{};
  curve.places[project::kSource] = {{30, 48}, {48, 54}, {66, 47}};
  curve.places[project::kDestination] = {{33, 50}, {40, 53}, {52, 55}, {63, 49}};
  project.features.push_back(curve);
  project.output.frames = 9;
  return project;
}

/// (1 - share) a + share b, in every channel.
inline warp::Image dissolved(const warp::Image& a, const warp::Image& b, float share) {
  warp::Image result(a.size());
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x)
      for (int c = 0; c < 4; ++c) result(y, x)[c] = (1 - share) * a(y, x)[c] + share * b(y, x)[c];
  return result;
}

/// Same size and the same bits in every channel; prints the first difference.
inline ::testing::AssertionResult same_bits(const warp::Image& a, const warp::Image& b) {
  if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " against " << b.size();
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x)
      if (std::memcmp(&a(y, x), &b(y, x), sizeof(warp::Pixel)) != 0)
        return ::testing::AssertionFailure() << "at (" << x << ", " << y << "): " << a(y, x) << " against " << b(y, x);
  return ::testing::AssertionSuccess();
}

}  // namespace morphkit::test
