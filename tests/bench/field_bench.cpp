// The line field alone: a 1080p frame, two targets, one thread. items_per_second counts pixels x lines.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <vector>

#include "warp/line_field.h"

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

struct Row {
  std::vector<MapPoint> first = std::vector<MapPoint>(kWidth);
  std::vector<MapPoint> second = std::vector<MapPoint>(kWidth);
  std::array<std::span<MapPoint>, 2> spans{first, second};
};

/// Largest difference from the reference over some rows, px.
double worst_error(const LineField& field) {
  Row fast;
  Row reference;
  double worst = 0;
  for (int y = 0; y < kHeight; y += 180) {
    field.row(y, 0, fast.spans);
    field.reference_row(y, 0, reference.spans);
    for (size_t i = 0; i < kWidth; ++i) {
      worst = std::max(worst, cv::norm(cv::Vec2d(fast.first[i]) - cv::Vec2d(reference.first[i])));
      worst = std::max(worst, cv::norm(cv::Vec2d(fast.second[i]) - cv::Vec2d(reference.second[i])));
    }
  }
  return worst;
}

void report(benchmark::State& state, const LineField& field) {
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight * state.range(0));
  const double worst = worst_error(field);
  state.counters["worst_px"] = worst;
  if (!(worst <= kFieldTolerancePx)) state.SkipWithError("row differs from reference_row");
}

void field_row(benchmark::State& state, LineWeight weight) {
  const LineField field = make_field(static_cast<int>(state.range(0)), weight);
  Row row;
  for ([[maybe_unused]] auto _ : state) {
    for (int y = 0; y < kHeight; ++y) {
      field.row(y, 0, row.spans);
      benchmark::DoNotOptimize(row.first.data());
      benchmark::ClobberMemory();
    }
  }
  report(state, field);
}

void field_reference(benchmark::State& state, LineWeight weight) {
  const LineField field = make_field(static_cast<int>(state.range(0)), weight);
  Row row;
  for ([[maybe_unused]] auto _ : state) {
    for (int y = 0; y < kHeight; ++y) {
      field.reference_row(y, 0, row.spans);
      benchmark::DoNotOptimize(row.first.data());
      benchmark::ClobberMemory();
    }
  }
  report(state, field);
}

constexpr LineWeight kPlain{1, 2, 0};
constexpr LineWeight kPaper{1, 1.5, 0.2};
constexpr LineWeight kOdd{1, 1.3, 0.2};

BENCHMARK_CAPTURE(field_row, b2, kPlain)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_row, b1_5_p0_2, kPaper)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_row, b1_3_p0_2, kOdd)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_reference, b1_5_p0_2, kPaper)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace morphkit::warp
