// Sampling of 1080p RGBA float through a smooth random warp, beside cv::remap on the same material (which quantises
// positions to 1/32 px). Argument: threads.

#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <stdexcept>

#include "warp/color.h"
#include "warp/parallel.h"
#include "warp/sample.h"

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

/// Into a buffer that stays, as a renderer does it; allocation of the frame is not what is measured.
void sample_frame(benchmark::State& state, Filter filter) {
  set_threads(static_cast<int>(state.range(0)));
  const Image& from = source();
  const Map& map = warp_map();
  const SampleOptions options{filter, Border::kTransparent};
  Image out(kSize, Pixel::all(0));  // touches the pages
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
  set_threads(static_cast<int>(state.range(0)));
  cv::Mat map;
  cv::subtract(warp_map(), cv::Scalar(0.5, 0.5), map);  // remap counts from the centre of pixel 0
  Image out(kSize, Pixel::all(0));                      // touches the pages
  for (auto _ : state) {
    cv::remap(source(), out, map, cv::noArray(), interpolation, cv::BORDER_CONSTANT);
    benchmark::ClobberMemory();
  }
  count(state);
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
BENCHMARK_CAPTURE(srgb_rows, decode, linear_from_srgb)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(srgb_rows, encode, srgb_from_linear)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace morphkit::warp
