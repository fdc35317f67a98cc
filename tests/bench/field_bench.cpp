// The line field alone: a 1080p frame, two targets; and the peak speed of the machine.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "base/parallel.h"
#include "tests/bench/fma_peak.h"
#include "tests/support/threads.h"
#include "warp/field/line_field.h"

namespace morphkit::warp {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;

/// Lines as in a morph of two faces: short, all over the frame, moved and turned a little.
LineField make_field(int lines, LineWeight weight) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  std::vector<FieldLine> set;
  for (int i = 0; i < lines; ++i) {
    const cv::Point2d p{uniform(0, kWidth), uniform(0, kHeight)};
    const cv::Point2d q = p + cv::Point2d{uniform(-200, 200), uniform(-200, 200)};
    FieldLine line{{p, q}, {}, weight, LineScale::kAlong, 0};
    for (int target = 0; target < 2; ++target) {
      const cv::Point2d move{uniform(-40, 40), uniform(-40, 40)};
      const cv::Point2d turn{uniform(-20, 20), uniform(-20, 20)};
      line.targets.push_back({p + move, q + move + turn});
    }
    set.push_back(line);
  }
  return {set, 2};
}

/// A whole frame, band by band like a renderer: into maps that stay in the cache until they are used.
void evaluate_frame(const LineField& field, FieldAccuracy accuracy) {
  for_rows(
      kHeight,
      [&](int begin, int end) {
        thread_local std::array<Map, 2> maps;
        for (Map& map : maps) map.create(end - begin, kWidth);
        field.evaluate({0, begin, kWidth, end - begin}, accuracy, maps);
        benchmark::DoNotOptimize(maps[0].data);
        benchmark::DoNotOptimize(maps[1].data);
        benchmark::ClobberMemory();
      },
      kFieldTile);
}

/// Largest distance from the reference over some rows, px.
double worst_error(const LineField& field, FieldAccuracy accuracy) {
  std::array<Map, 2> fast{Map(1, kWidth), Map(1, kWidth)};
  std::array<Map, 2> reference{Map(1, kWidth), Map(1, kWidth)};
  double worst = 0;
  for (int y = 0; y < kHeight; y += 83) {
    field.evaluate({0, y, kWidth, 1}, accuracy, fast);
    field.reference({0, y, kWidth, 1}, reference);
    for (int t = 0; t < 2; ++t) {
      for (int x = 0; x < kWidth; ++x)
        worst = std::max(worst, cv::norm(cv::Vec2d(fast[t](0, x)) - cv::Vec2d(reference[t](0, x))));
    }
  }
  return worst;
}

/// Arguments: lines, threads.
void field(benchmark::State& state, FieldAccuracy accuracy, LineWeight weight) {
  test::set_threads(static_cast<int>(state.range(1)));
  const LineField lines = make_field(static_cast<int>(state.range(0)), weight);
  for ([[maybe_unused]] auto _ : state) evaluate_frame(lines, accuracy);
  const double pixel_lines = static_cast<double>(kWidth) * kHeight * static_cast<double>(state.range(0));
  state.counters["ns_per_pixel_line"] = benchmark::Counter(
      pixel_lines * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  const double worst = worst_error(lines, accuracy);
  state.counters["worst_px"] = worst;
  if (!(worst <= (accuracy == FieldAccuracy::kExact ? kFieldTolerancePx : kAdaptiveTolerancePx)))
    state.SkipWithError("differs from the reference");
  test::set_threads(0);
}

/// The lower limit: the operations of a line at a pixel, for both sides at once, at the peak speed of the processor.
/// Its time is for 50 lines.
void flop_floor(benchmark::State& state) {
  constexpr double kFlopPerPixelLine = 38, kFlop = kFlopPerPixelLine * kWidth * kHeight * 50;
  std::int64_t flop = 0;
  constexpr std::int64_t kRounds = 1000;
  for ([[maybe_unused]] auto _ : state) {
    for (double done = 0; done < kFlop;) {
      const std::int64_t more = run_fma(kRounds);
      done += static_cast<double>(more);
      flop += more;
    }
  }
  state.counters["flop/s"] = benchmark::Counter(static_cast<double>(flop), benchmark::Counter::kIsRate);
}
BENCHMARK(flop_floor)->Unit(benchmark::kMillisecond);

constexpr LineWeight kPlain{1, 2, 0};
constexpr LineWeight kPaper{1, 1.5, 0.2};
constexpr LineWeight kOdd{1, 1.3, 0.2};
constexpr LineWeight kSteep{0, 4, 0};

#define MORPHKIT_FIELD(name, accuracy, weight, ...) \
  BENCHMARK_CAPTURE(field, name, accuracy, weight)  \
      ->ArgNames({"lines", "threads"})              \
      ->ArgsProduct({__VA_ARGS__})                  \
      ->Unit(benchmark::kMillisecond)               \
      ->UseRealTime()

MORPHKIT_FIELD(exact_b2, FieldAccuracy::kExact, kPlain, {10, 50, 500}, {1, 2});
MORPHKIT_FIELD(exact_b1_5, FieldAccuracy::kExact, kPaper, {50}, {1});
MORPHKIT_FIELD(exact_b1_3, FieldAccuracy::kExact, kOdd, {50}, {1});
MORPHKIT_FIELD(exact_b4_a0, FieldAccuracy::kExact, kSteep, {50}, {1});
MORPHKIT_FIELD(adaptive_b2, FieldAccuracy::kAdaptive, kPlain, {10, 50, 500, 5000}, {1, 2});
MORPHKIT_FIELD(adaptive_b1_5, FieldAccuracy::kAdaptive, kPaper, {50}, {1});
MORPHKIT_FIELD(adaptive_b1_3, FieldAccuracy::kAdaptive, kOdd, {50, 500}, {1});
MORPHKIT_FIELD(adaptive_b4_a0, FieldAccuracy::kAdaptive, kSteep, {50, 500}, {1});

}  // namespace
}  // namespace morphkit::warp
