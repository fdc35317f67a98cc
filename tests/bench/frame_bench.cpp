// A whole morph frame, 1080p: both warps and the dissolve, as `morphkit morph` renders it, without files.

#include <cmath>
#include <random>
#include <string>

#include <benchmark/benchmark.h>

#include "morph/render/renderer.h"
#include "tests/support/threads.h"

namespace morphkit::render {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

warp::Image noise(unsigned seed) {
  std::mt19937 random(seed);
  warp::Image image(kHeight, kWidth);
  for (warp::Pixel& pixel : image) {
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(random() >> 8) / 16777216.0f;
    pixel[3] = 1;
  }
  return image;
}

/// Random lines of 40 to 200 px with ends that move by up to 20 px, as people draw them on a face.
project::Project random_project(int lines) {
  std::mt19937 random(42);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  project::Project project;
  project.pull.a = 1;
  project.pull.b = 1.5;
  project.pull.p = 0.2;
  for (int i = 0; i < lines; ++i) {
    const cv::Point2d p(uniform(0, kWidth), uniform(0, kHeight));
    const double angle = uniform(0, 6.283), length = uniform(40, 200);
    const cv::Point2d q = p + length * cv::Point2d(std::cos(angle), std::sin(angle));
    const auto moved = [&](cv::Point2d x) { return x + cv::Point2d(uniform(-20, 20), uniform(-20, 20)); };
    project::Feature feature;
    feature.id = std::to_string(i);
    feature.places[project::kSource] = {p, q};
    feature.places[project::kDestination] = {moved(p), moved(q)};
    project.features.push_back(feature);
  }
  return project;
}

/// Arguments: lines, threads, filter.
void whole_frame(benchmark::State& state) {
  test::set_threads(static_cast<int>(state.range(1)));
  project::Project project = random_project(static_cast<int>(state.range(0)));
  project.warp.filter = static_cast<warp::Filter>(state.range(2));
  const warp::Image source = noise(1);
  const Renderer renderer(project, {{in_memory(source), in_memory(noise(2))}, {}});
  if (cv::norm(renderer.frame(renderer.clock().at(0)), source, cv::NORM_INF) != 0)
    state.SkipWithError("t = 0 is not the source");
  for (auto _ : state) benchmark::DoNotOptimize(renderer.frame(renderer.clock().at(0.5)));
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
  test::set_threads(0);
}

BENCHMARK(whole_frame)
    ->ArgNames({"lines", "threads", "filter"})
    ->ArgsProduct({{10, 50, 500},
                   {1, 2},
                   {static_cast<int>(warp::Filter::kBilinear), static_cast<int>(warp::Filter::kArea)}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace morphkit::render
