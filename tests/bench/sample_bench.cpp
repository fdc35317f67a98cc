// Sampling of 1080p RGBA float through a smooth random warp, compared with cv::remap on the same picture (which
// quantises positions to 1/32 px); and two pictures with their dissolve, compared with cv::remap and cv::addWeighted.
// Argument: threads.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "tests/support/threads.h"
#include "warp/image/color.h"
#include "warp/image/image_pool.h"
#include "warp/image/mix.h"
#include "warp/sample/sample.h"

namespace morphkit::warp {
namespace {

const cv::Size kSize(1920, 1080);
constexpr unsigned kSeed = 42;

const Image& source() {
  static const Image image = [] {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> value(0, 1);
    Image noise(kSize);
    for (Pixel& pixel : noise) pixel = {value(random), value(random), value(random), 1.0F};
    return noise;
  }();
  return image;
}

/// Waves of up to 60 px, partly beyond the edges.
const Map& warp_map() {
  static const Map map = [] {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> phase(0, 6.28);
    const double p[4] = {phase(random), phase(random), phase(random), phase(random)};
    Map waves(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        waves(y, x) = {static_cast<float>(x + 0.5 + 40 * std::sin(y / 150.0 + p[0]) + 20 * std::sin(x / 90.0 + p[1])),
                       static_cast<float>(y + 0.5 + 40 * std::sin(x / 170.0 + p[2]) + 20 * std::sin(y / 80.0 + p[3]))};
      }
    }
    return waves;
  }();
  return map;
}

void count(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kSize.area());
  state.counters["threads"] = static_cast<double>(threads());
}

/// Into a buffer that is reused, as in a renderer; the allocation of the frame is not measured.
void sample_frame(benchmark::State& state, Filter filter) {
  test::set_threads(static_cast<int>(state.range(0)));
  const Image& from = source();
  const Map& map = warp_map();
  const SampleOptions options{filter, Border::kTransparent};
  Image out = pooled_image(kSize);
  out.setTo(cv::Scalar::all(0));  // touches the pages
  for (auto _ : state) {
    for_rows(
        kSize.height,
        [&](int begin, int end) {
          Image band = out.rowRange(begin, end);
          sample_band(from, map.rowRange(begin, end), options, band);
        },
        kSampleBand);
    benchmark::ClobberMemory();
  }
  if (cv::norm(out, sample(from, map, options), cv::NORM_INF) != 0) throw std::logic_error("sample_band != sample");
  count(state);
}

void opencv_remap(benchmark::State& state, int interpolation) {
  test::set_threads(static_cast<int>(state.range(0)));
  cv::Mat map;
  cv::subtract(warp_map(), cv::Scalar(0.5, 0.5), map);  // remap counts from the centre of pixel 0
  Image out(kSize, Pixel::all(0));                      // touches the pages
  for (auto _ : state) {
    cv::remap(source(), out, map, cv::noArray(), interpolation, cv::BORDER_CONSTANT);
    benchmark::ClobberMemory();
  }
  count(state);
}

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  benchmark::ClobberMemory();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Two pictures and their even dissolve, in bands as a renderer makes them.
void sampled_pair(const Image (&from)[2], const Map (&map)[2], Filter filter, Image& out) {
  const SampleOptions options{filter, Border::kTransparent};
  constexpr float kHalf = 0.5F;
  for_rows(
      out.rows,
      [&](int begin, int end) {
        thread_local Image other;
        Image band = out.rowRange(begin, end);
        other.create(band.size());
        sample_band(from[0], map[0].rowRange(begin, end), options, band);
        sample_band(from[1], map[1].rowRange(begin, end), options, other);
        const auto width = static_cast<std::size_t>(band.cols);
        for (int y = 0; y < band.rows; ++y) mix_row({band[y], width}, {other[y], width}, {&kHalf, 1});
      },
      kSampleBand);
}

/// Runs both in turn, so that other load on the machine affects both. The reported time is ours.
void pair_beside_opencv(benchmark::State& state, Filter filter, int interpolation) {
  test::set_threads(static_cast<int>(state.range(0)));
  Image from[2] = {pooled_image(kSize), pooled_image(kSize)};
  source().copyTo(from[0]);
  cv::flip(source(), from[1], 1);
  const Map map[2] = {warp_map(), warp_map().clone()};
  cv::Mat from_centre[2];  // remap counts from the centre of pixel 0
  for (int i = 0; i < 2; ++i) cv::subtract(map[i], cv::Scalar(0.5, 0.5), from_centre[i]);
  Image out = pooled_image(kSize);
  Image theirs[3] = {pooled_image(kSize), pooled_image(kSize), pooled_image(kSize)};
  std::vector<double> our_seconds;
  std::vector<double> their_seconds;
  for (auto _ : state) {
    our_seconds.push_back(seconds_of([&] { sampled_pair(from, map, filter, out); }));
    their_seconds.push_back(seconds_of([&] {
      for (int i = 0; i < 2; ++i) {
        cv::remap(from[i], theirs[i], from_centre[i], cv::noArray(), interpolation, cv::BORDER_CONSTANT);
      }
      cv::addWeighted(theirs[0], 0.5, theirs[1], 0.5, 0, theirs[2]);
    }));
    state.SetIterationTime(our_seconds.back());
  }
  count(state);
  state.counters["opencv_ms"] = median(their_seconds) * 1e3;
  state.counters["ours_ms"] = median(our_seconds) * 1e3;
  state.counters["ours_to_opencv"] = median(our_seconds) / median(their_seconds);
}

void srgb_rows(benchmark::State& state, void (*convert)(std::span<float>)) {
  const std::size_t width = static_cast<std::size_t>(kSize.width);
  std::vector<float> values(width * 3);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> value(0, 1);
  for (float& v : values) v = value(random);
  std::vector<float> work(values.size());
  for (auto _ : state) {
    for (int y = 0; y < kSize.height; ++y) {
      work = values;
      convert(work);
      benchmark::ClobberMemory();
    }
  }
  state.SetItemsProcessed(state.iterations() * kSize.area());
}

#define MORPHKIT_BENCH(function, name, ...) \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()

MORPHKIT_BENCH(sample_frame, nearest, Filter::kNearest);
MORPHKIT_BENCH(sample_frame, bilinear, Filter::kBilinear);
MORPHKIT_BENCH(sample_frame, bicubic, Filter::kBicubic);
MORPHKIT_BENCH(opencv_remap, linear, cv::INTER_LINEAR);
MORPHKIT_BENCH(opencv_remap, cubic, cv::INTER_CUBIC);
BENCHMARK_CAPTURE(pair_beside_opencv, bilinear, Filter::kBilinear, cv::INTER_LINEAR)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(pair_beside_opencv, bicubic, Filter::kBicubic, cv::INTER_CUBIC)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(srgb_rows, decode, linear_from_srgb)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(srgb_rows, encode, srgb_from_linear)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace morphkit::warp
