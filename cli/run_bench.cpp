#include "cli/cmd_bench.h"

#include <stdlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/parallel.h"
#include "base/vector_target.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "morph/job/pictures.h"
#include "morph/media/frame_sink.h"
#include "morph/project/words.h"
#include "morph/render/compose.h"
#include "morph/render/dissolve.h"
#include "morph/render/renderer.h"

namespace morphkit::cli {
namespace {

constexpr int kDefaultLines = 50;
const cv::Size kDefaultSize(1920, 1080);
constexpr double kMoment = 0.5;
constexpr unsigned kSeed = 42;
constexpr const char* kUnfinished = "nothing was measured to its end";

struct Timing {
  const char* key;   ///< for machines
  const char* name;  ///< for people
  double ms = 0;     ///< of a frame; below 0: not measured
  std::string note;
};

/// A folder for the video, gone with everything in it in the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "morphkit-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw Error(ErrorKind::kIo, name, "cannot be made: " + std::generic_category().message(errno));
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

double elapsed_ms(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The median of at least five runs, of more if they are quick. The first run does not count: it fetches memory.
double median_ms(const std::function<void()>& work) {
  constexpr std::size_t kFewest = 5, kMost = 51;
  constexpr double kEnoughMs = 800;
  work();
  std::vector<double> times;
  for (double total = 0; times.size() < kFewest || (total < kEnoughMs && times.size() < kMost); total += times.back()) {
    stop_if_interrupted(kUnfinished);
    times.push_back(elapsed_ms(work));
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// Soft shapes with camera noise: as hard for codecs as photographs.
warp::Image painted(cv::Size size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  const float phase = 6.28F * uniform(random);
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float u = static_cast<float>(x) / 190.0F + phase;
      const float v = static_cast<float>(y) / 150.0F - phase;
      const float noise = 0.01F * uniform(random);
      image(y, x) = {0.3F + 0.2F * std::sin(u + std::sin(v)) + noise, 0.3F + 0.2F * std::sin(v * 1.3F + u) + noise,
                     0.3F + 0.2F * std::cos(u - 0.7F * v) + noise, 1.0F};
    }
  }
  return image;
}

/// Lines of 40 to 200 px whose ends move by up to 20 px, as people draw them on a face.
void add_random_lines(int lines, cv::Size size, project::Project& project) {
  std::mt19937 random(kSeed);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < lines; ++i) {
    const cv::Point2d p(uniform(0, size.width), uniform(0, size.height));
    const double angle = uniform(0, 2 * CV_PI);
    const cv::Point2d q = p + uniform(40, 200) * cv::Point2d(std::cos(angle), std::sin(angle));
    const auto moved = [&](cv::Point2d point) { return point + cv::Point2d(uniform(-20, 20), uniform(-20, 20)); };
    project::Feature feature;
    feature.id = std::to_string(i + 1);
    feature.places[project::kSource] = {p, q};
    feature.places[project::kDestination] = {moved(p), moved(q)};
    project.features.push_back(std::move(feature));
  }
}

struct Material {
  project::Project project;
  render::Footage footage;
};

Material painted_material(const BenchOptions& options) {
  Material material;
  for (project::Picture& picture : material.project.pictures) picture.image = "painted";
  apply_changes(options.changes, material.project);
  const cv::Size size = material.project.output.size.value_or(kDefaultSize);
  add_random_lines(options.lines.value_or(kDefaultLines), size, material.project);
  for (const unsigned seed : {kSeed, kSeed + 1})
    material.footage.pictures.push_back(render::in_memory(painted(size, seed)));
  return material;
}

Material make_material(const BenchOptions& options) {
  if (options.project.empty()) return painted_material(options);
  if (options.lines) throw ArgumentError("--lines", "goes without a project; a project has its own features");
  Material material;
  material.project = load_project(options.project, options.changes);
  material.footage = job::footage_of(job::load_pictures(material.project));
  return material;
}

/// The parts of a frame, each over a whole frame by itself; `frame` does them together, band by band.
void measure_parts(const render::Renderer& renderer, std::vector<Timing>& timings) {
  using project::kDestination;
  using project::kSource;
  using project::SideIndex;
  timings.push_back({"field", "field", median_ms([&] { renderer.map(renderer.clock().at(kMoment), kSource); }), ""});

  const render::Stage& stage = renderer.stage();
  const warp::Map to_source = renderer.map(renderer.clock().at(kMoment), project::kSource, render::Pixels::kHeld);
  const warp::Map to_destination =
      renderer.map(renderer.clock().at(kMoment), project::kDestination, render::Pixels::kHeld);
  const warp::Filter filter = renderer.project().warp.filter;
  warp::Image source(renderer.size()), destination(renderer.size());
  const double sampling_ms = median_ms([&] {
    render::sample_side(stage.sides[project::kSource], to_source, filter, source);
    render::sample_side(stage.sides[project::kDestination], to_destination, filter, destination);
  });
  timings.push_back({"sampling", "sampling", sampling_ms, "both pictures"});

  const auto width = static_cast<std::size_t>(source.cols);
  const float half = 0.5F;
  const double dissolve_ms = median_ms([&] {
    for_rows(source.rows, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        render::dissolve_row({source[y], width}, {destination[y], width}, std::span(&half, 1),
                             renderer.project().blend);
    });
  });
  timings.push_back({"dissolve", "dissolve", dissolve_ms, ""});
}

void measure_video(const render::Renderer& renderer, const warp::Image& frame, std::vector<Timing>& timings) {
  constexpr int kFrames = 24;
  constexpr std::size_t kPacketsBytes = std::size_t{256} << 20;
  const ScratchFolder folder;
  media::SinkOptions options;
  options.size = renderer.size();
  options.has_alpha = renderer.has_alpha();
  std::unique_ptr<media::FrameSink> sink;
  try {
    sink = media::open_sink(folder.path() / "bench.mp4", options, false);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kIo) throw;
    timings.push_back({"mp4", "to .mp4", -1, "not measured: " + std::string(error.message())});
    return;
  }
  timings.push_back({"raw_video", "to raw video", median_ms([&] { sink->encode(0, frame); }), "what ffmpeg is given"});
  // Different pictures, as many as fit: a codec is quick with one that stands still.
  std::vector<media::FrameSink::Packet> packets;
  while (packets.size() < 2 || (packets.size() < kFrames && packets.size() * packets[0].size() < kPacketsBytes)) {
    stop_if_interrupted(kUnfinished);
    const int i = static_cast<int>(packets.size());
    packets.push_back(sink->encode(i, renderer.frame(renderer.clock().at(static_cast<double>(i) / (kFrames - 1)))));
  }
  const double ms = elapsed_ms([&] {
    for (int i = 0; i < kFrames; ++i) {
      stop_if_interrupted(kUnfinished);
      sink->write(i, packets[static_cast<std::size_t>(i) % packets.size()]);
    }
    sink->finish();
  });
  timings.push_back({"mp4", "to .mp4", ms / kFrames, fmt::format("by ffmpeg on its own threads, {} frames", kFrames)});
}

std::vector<Timing> measure(const render::Renderer& renderer) {
  std::vector<Timing> timings;
  const bool parts = project::method_name_of(renderer.project()) == project::MethodName::kLines;
  if (parts) measure_parts(renderer, timings);
  timings.push_back({"frame", "whole frame", median_ms([&] { renderer.frame(renderer.clock().at(kMoment)); }),
                     parts ? "the three above together" : ""});
  const warp::Image frame = renderer.frame(renderer.clock().at(kMoment));
  const double png_ms = median_ms([&] { media::encode_image("bench.png", frame); });
  timings.push_back({"png", "to 8-bit PNG", png_ms, "one thread; morph does several frames at once"});
  measure_video(renderer, frame, timings);
  return timings;
}

void print_text(const render::Renderer& renderer, const std::vector<Timing>& timings, Output& output) {
  output.line(fmt::format("{}x{}, {}; filter {}; {} thread{}; vectors {}", renderer.size().width,
                          renderer.size().height, renderer.description(),
                          project::word_of(renderer.project().warp.filter), threads(), threads() == 1 ? "" : "s",
                          vector_target()));
  for (const Timing& timing : timings) {
    const std::string time = timing.ms < 0 ? "-" : fmt::format("{:.2f}", timing.ms);
    const std::string note = timing.note.empty() ? "" : "   " + timing.note;
    output.line(fmt::format("  {:<14}{:>9} ms{}", timing.name, time, note));
  }
}

void print_json(const render::Renderer& renderer, const std::vector<Timing>& timings, Output& output) {
  Report times;
  for (const Timing& timing : timings) times.set(timing.key, timing.ms < 0 ? Report(nullptr) : Report(timing.ms));
  Report report;
  report.set("width", renderer.size().width).set("height", renderer.size().height);
  report.set("work", renderer.description())
      .set("filter", std::string(project::word_of(renderer.project().warp.filter)));
  report.set("threads", threads()).set("vectors", vector_target()).set("ms", std::move(times));
  output.line(report.to_json());
}

}  // namespace

int run_bench(const BenchOptions& options, Output& output) {
  const Material material = make_material(options);
  // How long a mesh takes does not depend on whether it folds.
  const render::Renderer renderer(material.project, material.footage, {.allow_folds = true});
  const std::vector<Timing> timings = as_asked([&] { return measure(renderer); });
  options.json ? print_json(renderer, timings, output) : print_text(renderer, timings, output);
  return 0;
}

}  // namespace morphkit::cli
