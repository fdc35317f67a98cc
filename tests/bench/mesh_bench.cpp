// Mesh warps: a line, an image, a whole 1080p morph frame (two warps and the dissolve), and their accuracy. For
// comparison, Debian's libmorph on the same meshes and pictures, if it is installed: 8 bits, three channels, its
// filters "bilinear" and "lanczos" (its default). Skipped benchmarks say so.

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "base/parallel.h"
#include "morph/render/dissolve.h"
#include "tests/support/threads.h"
#include "tests/unit/warp/mesh/mesh_pictures.h"
#include "warp/mesh/area_resample.h"
#include "warp/mesh/mesh_warp.h"

#ifdef MORPHKIT_HAVE_LIBMORPH
// Debian's headers include one that Debian does not ship.
extern "C" {
void warp_image_versatile(const unsigned char* source, int source_width, int source_height, int source_channels,
                          int source_row_stride, int source_pixel_stride, unsigned char* destination,
                          int destination_width, int destination_height, int destination_channels,
                          int destination_row_stride, int destination_pixel_stride, const double* source_x,
                          const double* source_y, const double* destination_x, const double* destination_y,
                          int mesh_width, int mesh_height);
void mesh_resample_choose_aa_by_name(char* name);
}
#endif

namespace morphkit::warp {
namespace {

using test::bent_mesh;
using test::Photograph;
using test::plate_quality;
using test::PlateQuality;
using test::psnr;
using test::reference_pixels;
using test::ReferencePixel;
using test::ZonePlate;

const cv::Size kFrame(1920, 1080);
const cv::Size kPhotographSize(600, 400);
constexpr int kStride = 11;  // between pixels that are compared

Image noise(unsigned seed) {
  std::mt19937 random(seed);
  Image image(kFrame);
  for (Pixel& pixel : image) {
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(random() >> 8) / 16777216.0F;
    pixel[3] = 1;
  }
  return image;
}

/// The meshes of both ends and of the middle of a morph, `vertices` in a row and in a column.
struct MorphMeshes {
  explicit MorphMeshes(int vertices)
      : source(bent_mesh(vertices, vertices, kFrame, 0.02, 0.1, 1)),
        destination(bent_mesh(vertices, vertices, kFrame, 0.02, 0.1, 2)),
        middle(source) {
    for (std::size_t i = 0; i < middle.vertices.size(); ++i) {
      middle.vertices[i] = (source.vertices[i] + destination.vertices[i]) / 2;
    }
  }
  Mesh source, destination, middle;
};

// ---- morphkit

/// Argument: source pixels per 100 output pixels. 100: whole pixels.
void line(benchmark::State& state) {
  const std::size_t size = 1920;
  const double scale = static_cast<double>(state.range(0)) / 100;
  const Image picture = noise(1);
  std::vector<double> edges;
  for (double at = 0; at <= static_cast<double>(size); at += scale) edges.push_back(at);
  std::vector<Pixel> out(edges.size() - 1);
  for (auto _ : state) {
    resample_line({picture[0], size}, {edges, 0, static_cast<double>(out.size())}, out);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(out.size()));
}
BENCHMARK(line)->ArgName("percent")->Arg(50)->Arg(99)->Arg(100)->Arg(103)->Arg(200)->Arg(810);

using Registered = benchmark::internal::Benchmark;

void vertices(Registered* to) {
  to->ArgName("vertices")->Arg(10)->Arg(30)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();
}

void vertices_and_threads(Registered* to) {
  to->ArgNames({"vertices", "threads"})->ArgsProduct({{10, 30, 500}, {1, 2}});
  to->Unit(benchmark::kMillisecond)->UseRealTime();
}

/// Runs a quality measurement in dB once.
void once(Registered* to) {
  to->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
}

void once_each_strength(Registered* to) {
  once(to->ArgName("strong")->Arg(0)->Arg(1));
}

/// Arguments: vertices, threads.
void one_warp(benchmark::State& state) {
  test::set_threads(static_cast<int>(state.range(1)));
  const MorphMeshes meshes(static_cast<int>(state.range(0)));
  const Image picture = noise(1);
  const MeshWarp warp(meshes.source, meshes.middle);
  for (auto _ : state) benchmark::DoNotOptimize(warp.apply(picture, kFrame));
  state.SetItemsProcessed(state.iterations() * kFrame.area());
  test::set_threads(0);
}
BENCHMARK(one_warp)->Apply(vertices_and_threads);

/// Arguments: vertices, threads. From meshes to pixels: a frame has its own in-between mesh.
void frame(benchmark::State& state) {
  test::set_threads(static_cast<int>(state.range(1)));
  const MorphMeshes meshes(static_cast<int>(state.range(0)));
  const Image pictures[2] = {noise(1), noise(2)};
  const auto width = static_cast<std::size_t>(kFrame.width);
  constexpr float kHalf[1] = {0.5F};
  for (auto _ : state) {
    Image result = MeshWarp(meshes.source, meshes.middle).apply(pictures[0], kFrame);
    const Image other = MeshWarp(meshes.destination, meshes.middle).apply(pictures[1], kFrame);
    for_rows(kFrame.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        render::dissolve_row({result[y], width}, {other[y], width}, kHalf, project::Blend::kLinear);
    });
    benchmark::DoNotOptimize(result.data);
  }
  state.SetItemsProcessed(state.iterations() * kFrame.area());
  test::set_threads(0);
}
BENCHMARK(frame)->Apply(vertices_and_threads);

// ---- Quality, in dB, as counters.

/// One picture with its meshes, and the correct result.
struct Trial {
  Mesh from, to;
  Image source;
  cv::Size out;
  std::vector<ReferencePixel> references;
};

const Trial& plate_trial() {
  static const Trial trial = [] {
    const MeshWarp warp(ZonePlate::from(), ZonePlate::to());
    return Trial{warp.from(),
                 warp.to(),
                 ZonePlate::source(),
                 {ZonePlate::kOutputSize, ZonePlate::kOutputSize},
                 reference_pixels(warp, ZonePlate::measured(), kStride, ZonePlate::value)};
  }();
  return trial;
}

/// Dense meshes of a smooth bend: the map is the same for any curves through the vertices.
const Trial& photograph_trial(bool strong) {
  static const auto make = [](double swirl, unsigned seed) {
    const Photograph photograph(kPhotographSize);
    const MeshWarp warp(bent_mesh(61, 41, kPhotographSize, swirl, 0, seed),
                        bent_mesh(61, 41, kPhotographSize, swirl, 0, seed + 1));
    const cv::Rect inner(8, 8, kPhotographSize.width - 16, kPhotographSize.height - 16);
    return Trial{warp.from(), warp.to(), photograph.image(), kPhotographSize,
                 reference_pixels(warp, inner, kStride, [&](cv::Point2d at) { return photograph.value(at); })};
  };
  static const Trial trials[2] = {make(0.03, 1), make(0.12, 3)};
  return trials[strong ? 1 : 0];
}

/// warp(trial) gives a function from an output pixel to its grey.
template <typename Warp>
void measure_plate(benchmark::State& state, const Warp& warp) {
  const Trial& trial = plate_trial();
  for (auto _ : state) {
    const PlateQuality quality = plate_quality(ZonePlate::plate(), trial.references, warp(trial));
    state.counters["whole"] = quality.whole;
    state.counters["passband"] = quality.passband;
    state.counters["alias_zone"] = quality.alias_zone;
  }
}

template <typename Warp>
void measure_photograph(benchmark::State& state, const Warp& warp) {
  const Trial& trial = photograph_trial(state.range(0) != 0);
  for (auto _ : state) {
    state.counters["psnr"] = psnr(trial.references, warp(trial), [](cv::Point) { return true; });
  }
}

auto warped(const Trial& trial) {
  const Image out = MeshWarp(trial.from, trial.to).apply(trial.source, trial.out);
  return [out](cv::Point at) { return static_cast<double>(out(at)[1]); };
}

void plate(benchmark::State& state) {
  measure_plate(state, warped);
}
BENCHMARK(plate)->Apply(once);

void photograph(benchmark::State& state) {
  measure_photograph(state, warped);
}
BENCHMARK(photograph)->Apply(once_each_strength);

// ---- libmorph

#ifdef MORPHKIT_HAVE_LIBMORPH

using Bytes = cv::Mat_<cv::Vec3b>;

Bytes to_bytes(const Image& image) {
  Bytes bytes(image.size());
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      for (int c = 0; c < 3; ++c) bytes(y, x)[c] = cv::saturate_cast<uchar>(255 * image(y, x)[c]);
    }
  }
  return bytes;
}

/// Its pixel centres are whole numbers. Of all shifts by half a pixel, this one gives its best pictures.
class Coordinates {
 public:
  explicit Coordinates(const Mesh& mesh) {
    for (const cv::Point2d& vertex : mesh.vertices) {
      x_.push_back(vertex.x - 0.5);
      y_.push_back(vertex.y - 0.5);
    }
  }
  const double* x() const { return x_.data(); }
  const double* y() const { return y_.data(); }

 private:
  std::vector<double> x_, y_;
};

Bytes libmorph_warp(const Bytes& source, cv::Size size, const Mesh& from, const Mesh& to, std::string filter) {
  mesh_resample_choose_aa_by_name(filter.data());
  Bytes out(size, cv::Vec3b());
  const Coordinates source_mesh(from);
  const Coordinates out_mesh(to);
  warp_image_versatile(source.data, source.cols, source.rows, 3, static_cast<int>(source.step[0]), 3, out.data,
                       out.cols, out.rows, 3, static_cast<int>(out.step[0]), 3, source_mesh.x(), source_mesh.y(),
                       out_mesh.x(), out_mesh.y(), from.columns, from.rows);
  return out;
}

void libmorph_frame(benchmark::State& state, const std::string& filter) {
  const MorphMeshes meshes(static_cast<int>(state.range(0)));
  const Bytes pictures[2] = {to_bytes(noise(1)), to_bytes(noise(2))};
  for (auto _ : state) {
    Bytes result = libmorph_warp(pictures[0], kFrame, meshes.source, meshes.middle, filter);
    const Bytes other = libmorph_warp(pictures[1], kFrame, meshes.destination, meshes.middle, filter);
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(kFrame.area()); ++i) {
      result.data[i] = static_cast<uchar>((result.data[i] + other.data[i] + 1) / 2);
    }
    benchmark::DoNotOptimize(result.data);
  }
  state.SetItemsProcessed(state.iterations() * kFrame.area());
}

auto libmorph_warped(const std::string& filter) {
  return [filter](const Trial& trial) {
    const Bytes out = libmorph_warp(to_bytes(trial.source), trial.out, trial.from, trial.to, filter);
    return [out](cv::Point at) { return out(at)[1] / 255.0; };
  };
}

void libmorph_plate(benchmark::State& state, const std::string& filter) {
  measure_plate(state, libmorph_warped(filter));
}

void libmorph_photograph(benchmark::State& state, const std::string& filter) {
  measure_photograph(state, libmorph_warped(filter));
}

#else

void skip(benchmark::State& state, const std::string&) {
  state.SkipWithError("libmorph (Debian: libmorph-dev) is not installed");
}
constexpr auto libmorph_frame = skip;
constexpr auto libmorph_plate = skip;
constexpr auto libmorph_photograph = skip;

#endif

BENCHMARK_CAPTURE(libmorph_frame, bilinear, "bilinear")->Apply(vertices);
BENCHMARK_CAPTURE(libmorph_frame, lanczos, "lanczos")->Apply(vertices);
BENCHMARK_CAPTURE(libmorph_plate, bilinear, "bilinear")->Apply(once);
BENCHMARK_CAPTURE(libmorph_plate, lanczos, "lanczos")->Apply(once);
BENCHMARK_CAPTURE(libmorph_photograph, bilinear, "bilinear")->Apply(once_each_strength);
BENCHMARK_CAPTURE(libmorph_photograph, lanczos, "lanczos")->Apply(once_each_strength);

}  // namespace
}  // namespace morphkit::warp
