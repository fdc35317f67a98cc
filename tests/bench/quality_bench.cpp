// Accuracy of sampling, in dB of PSNR, and its cost where a picture shrinks: a zone plate of 2048 x 2048 px reduced by
// a radial map to 1024 x 1024. For comparison, cv::remap and bilinear supersampling on the same picture.

#include <cmath>
#include <opencv2/imgproc.hpp>

#include <benchmark/benchmark.h>

#include "base/parallel.h"
#include "tests/support/threads.h"
#include "tests/unit/warp/sample/plate_reference.h"
#include "warp/sample/sample.h"

namespace morphkit::warp {
namespace {

using test::grey_image;
using test::plate_quality;
using test::PlateQuality;
using test::PlateReduction;
using test::ReferencePixel;

constexpr int kStride = 7;  // between pixels that are compared

struct Material {
  Image source = PlateReduction::source();
  Map map = PlateReduction::map();
  std::vector<ReferencePixel> box = PlateReduction::box_references(kStride);
  std::vector<ReferencePixel> lanczos = PlateReduction::lanczos_references(kStride);
};

const Material& material() {
  static const Material instance;
  return instance;
}

void report(benchmark::State& state, const Image& out) {
  const auto grey = [&](cv::Point at) { return static_cast<double>(out(at)[1]); };
  const PlateQuality box = plate_quality(PlateReduction::plate(), material().box, grey);
  state.counters["whole"] = box.whole;
  state.counters["passband"] = box.passband;
  state.counters["alias"] = box.alias_zone;
  const PlateQuality lanczos = plate_quality(PlateReduction::plate(), material().lanczos, grey);
  state.counters["whole_L"] = lanczos.whole;
  state.counters["passband_L"] = lanczos.passband;
  state.counters["alias_L"] = lanczos.alias_zone;
  state.SetItemsProcessed(state.iterations() * out.size().area());
}

void plate(benchmark::State& state, Filter filter) {
  test::set_threads(1);
  const Material& m = material();
  Image out;
  for (auto _ : state) out = sample(m.source, m.map, {filter, Border::kClamp});
  report(state, out);
}

void plate_opencv(benchmark::State& state, int interpolation) {
  test::set_threads(1);
  cv::Mat map;
  const Material& m = material();
  cv::subtract(m.map, cv::Scalar(0.5, 0.5), map);  // remap counts from the centre of pixel 0
  Image out;
  for (auto _ : state) cv::remap(m.source, out, map, cv::noArray(), interpolation, cv::BORDER_REPLICATE);
  report(state, out);
}

/// Supersampling, the method without a filter: the map at four times the size, bilinear, then the mean of 4 x 4 px.
void plate_supersampled(benchmark::State& state) {
  test::set_threads(1);
  const Material& m = material();
  cv::Mat fine(4 * PlateReduction::kOutputSize, 4 * PlateReduction::kOutputSize, CV_32FC2);
  fine.forEach<cv::Vec2f>([](cv::Vec2f& position, const int* at) {
    const cv::Point2d p = PlateReduction::plate().radial({(at[1] + 0.5) / 4, (at[0] + 0.5) / 4});
    position = cv::Vec2f(static_cast<float>(p.x), static_cast<float>(p.y)) - cv::Vec2f(0.5F, 0.5F);
  });
  Image large;
  Image out;
  for (auto _ : state) {
    cv::remap(m.source, large, fine, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::resize(large, out, m.map.size(), 0, 0, cv::INTER_AREA);
  }
  report(state, out);
}

/// A 1080p picture rotated by 10 degrees at its size: the cost of a filter with nothing to average.
void turned(benchmark::State& state, Filter filter) {
  test::set_threads(1);
  const cv::Size size(1920, 1080);
  const Image source = grey_image(size, [](double x, double y) { return 0.5 + 0.5 * std::sin(0.3 * x + 0.2 * y); });
  Map map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double u = x - size.width / 2.0;
      const double v = y - size.height / 2.0;
      map(y, x) = {static_cast<float>(size.width / 2.0 + 0.9848 * u - 0.1736 * v),
                   static_cast<float>(size.height / 2.0 + 0.1736 * u + 0.9848 * v)};
    }
  }
  Image out(size, Pixel::all(0));  // touches the pages
  for (auto _ : state) {
    for_rows(
        size.height,
        [&](int begin, int end) {
          Image band = out.rowRange(begin, end);
          sample_band(source, map.rowRange(begin, end), {filter, Border::kTransparent}, band);
        },
        kSampleBand);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * size.area());
}

#define MORPHKIT_PLATE(function, name, ...) \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__)->Unit(benchmark::kMillisecond)->UseRealTime()

MORPHKIT_PLATE(plate, nearest, Filter::kNearest);
MORPHKIT_PLATE(plate, bilinear, Filter::kBilinear);
MORPHKIT_PLATE(plate, bicubic, Filter::kBicubic);
MORPHKIT_PLATE(plate, area, Filter::kArea);
MORPHKIT_PLATE(plate, mitchell, Filter::kMitchell);
MORPHKIT_PLATE(plate, lanczos, Filter::kLanczos);
MORPHKIT_PLATE(plate_opencv, linear, cv::INTER_LINEAR);
MORPHKIT_PLATE(plate_opencv, cubic, cv::INTER_CUBIC);
MORPHKIT_PLATE(plate_opencv, lanczos4, cv::INTER_LANCZOS4);
MORPHKIT_PLATE(turned, bilinear, Filter::kBilinear);
MORPHKIT_PLATE(turned, bicubic, Filter::kBicubic);
MORPHKIT_PLATE(turned, area, Filter::kArea);
BENCHMARK(plate_supersampled)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace morphkit::warp
