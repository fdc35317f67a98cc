// The cost of writing a 1080p frame: its conversion to codes (argument: threads), and the still image formats.

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "morph/media/image_file.h"
#include "morph/media/raw_frame.h"
#include "samples/samples.h"
#include "tests/support/threads.h"
#include "warp/image/color.h"
#include "warp/image/color_rows.h"

namespace morphkit::media {
namespace {

const cv::Size kSize(1920, 1080);

/// A painted portrait with the noise of a camera: the speed of a codec depends on the picture.
const warp::Image& frame() {
  static const warp::Image image = [] {
    cv::Mat4b large;
    cv::resize(samples::paint(samples::names().front()).pictures.front().pixels, large, kSize, 0, 0, cv::INTER_CUBIC);
    std::mt19937 random(42);
    std::normal_distribution<float> noise(0, 1.0F / 255);
    warp::Image linear(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        for (int c = 0; c < 3; ++c)
          linear(y, x)[c] = warp::linear_from_srgb(static_cast<float>(large(y, x)[c]) / 255 + noise(random));
        linear(y, x)[3] = 1;
      }
    }
    return linear;
  }();
  return image;
}

void raw(benchmark::State& state, RawFormat format) {
  test::set_threads(static_cast<int>(state.range(0)));
  const warp::Image& image = frame();
  for (auto _ : state) benchmark::DoNotOptimize(raw_frame(image, format, kSize));
  state.SetItemsProcessed(state.iterations() * kSize.area());
  test::set_threads(0);
}

/// The conversion alone, by the kernel or by its specification.
template <typename Code>
void codes(benchmark::State& state, void (*convert)(std::span<const warp::Pixel>, int, Code*) noexcept) {
  const warp::Image& image = frame();
  std::vector<Code> row(static_cast<std::size_t>(kSize.width) * 3);
  for (auto _ : state) {
    for (int y = 0; y < kSize.height; ++y) {
      convert({image[y], static_cast<std::size_t>(kSize.width)}, 3, row.data());
      benchmark::ClobberMemory();
    }
  }
  state.SetItemsProcessed(state.iterations() * kSize.area());
}

/// Argument: the level of compression, -1 for the default.
void still(benchmark::State& state, const char* name, Depth depth) {
  test::set_threads(1);
  WriteOptions options;
  options.depth = depth;
  options.compression = static_cast<int>(state.range(0));
  const warp::Image& image = frame();
  std::size_t bytes = 0;
  for (auto _ : state) bytes = encode_image(name, image, options).size();
  state.SetItemsProcessed(state.iterations() * kSize.area());
  state.counters["bytes"] = static_cast<double>(bytes);
  test::set_threads(0);
}

#define MORPHKIT_BENCH(function, name, ...) \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()

MORPHKIT_BENCH(raw, rgb24, RawFormat::kRgb24);
MORPHKIT_BENCH(raw, rgb48, RawFormat::kRgb48);
MORPHKIT_BENCH(raw, rgba64, RawFormat::kRgba64);
MORPHKIT_BENCH(raw, yuv420p, RawFormat::kYuv420p);
MORPHKIT_BENCH(raw, yuv422p10, RawFormat::kYuv422p10);
MORPHKIT_BENCH(raw, yuva444p10, RawFormat::kYuva444p10);
BENCHMARK_CAPTURE(codes, kernel_8, warp::srgb_codes<std::uint8_t>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(codes, kernel_16, warp::srgb_codes<std::uint16_t>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(codes, reference_8, warp::reference_srgb_codes<std::uint8_t>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(codes, reference_16, warp::reference_srgb_codes<std::uint16_t>)->Unit(benchmark::kMillisecond);
#define MORPHKIT_STILL(name, ...) \
  BENCHMARK_CAPTURE(still, name, __VA_ARGS__)->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(-1)
MORPHKIT_STILL(png_8, "frame.png", Depth::k8)->Arg(1)->Arg(2)->Arg(6);
MORPHKIT_STILL(png_16, "frame.png", Depth::k16)->Arg(1)->Arg(2);
MORPHKIT_STILL(tiff_16, "frame.tif", Depth::k16)->Arg(1)->Arg(3)->Arg(6);
MORPHKIT_STILL(exr_half, "frame.exr", Depth::kHalf)->Arg(1)->Arg(3)->Arg(4);
MORPHKIT_STILL(jpeg, "frame.jpg", Depth::k8);
MORPHKIT_STILL(webp, "frame.webp", Depth::k8);

}  // namespace
}  // namespace morphkit::media
