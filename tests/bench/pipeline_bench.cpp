// A whole job compared with its codec alone: frames of a project rendered to files, and the same frames, already in
// memory, through the same sink and pipeline. Prints rates, CPU times and the largest resident size.
//
//   bench_pipeline PROJECT OUT [repetitions]

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "morph/job/run.h"
#include "morph/media/frame_sink.h"

namespace morphkit::job {
namespace {

/// The cost of one run. CPU times include programs that have ended.
struct Cost {
  double wall_s = 0, own_s = 0, children_s = 0;
};

double cpu_s(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Cost cost_of(const std::function<void()>& work) {
  const double own = cpu_s(RUSAGE_SELF);
  const double children = cpu_s(RUSAGE_CHILDREN);
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), cpu_s(RUSAGE_SELF) - own, cpu_s(RUSAGE_CHILDREN) - children};
}

class Job {
 public:
  Job(const char* project_file, const char* output) : Job(project::load(project_file), output) {}

  Job(const project::Project& project, const char* output)
      : pictures_(load_pictures(project)), renderer_(project, footage_of(pictures_)), output_(output) {
    const project::Output& out = renderer_.project().output;
    frames_.resize(static_cast<std::size_t>(out.frames));
    std::iota(frames_.begin(), frames_.end(), out.start);
  }

  std::size_t count() const { return frames_.size(); }

  void whole() {
    const auto to = sink();
    RunOptions options;
    options.frames = frames_;
    options.in_flight = in_flight();
    run(renderer_, *to, options);
  }

  void render_alone() {
    for (const int frame : frames_) renderer_.frame(renderer_.time_of(frame));
  }

  /// @pre keep_frames()
  void codec_alone() {
    const auto to = sink();
    const auto make = [&](std::int64_t i) {
      const auto index = static_cast<std::size_t>(i);
      return to->encode(frames_[index], kept_[index]);
    };
    const auto deliver = [&](std::int64_t i, media::FrameSink::Packet packet) {
      to->write(frames_[static_cast<std::size_t>(i)], std::move(packet));
    };
    run_pipeline(static_cast<std::int64_t>(count()), in_flight(), make, deliver);
    to->finish();
  }

  void keep_frames() {
    kept_.reserve(count());
    for (const int frame : frames_) kept_.push_back(renderer_.frame(renderer_.time_of(frame)));
  }

 private:
  static int in_flight() { return threads() + 3; }

  std::unique_ptr<media::FrameSink> sink() const {
    media::SinkOptions options = sink_options(renderer_, pictures_);
    options.image.overwrite = true;
    return media::open_sink(output_, options, count() == 1);
  }

  Pictures pictures_;
  render::Renderer renderer_;
  const char* output_;
  std::vector<int> frames_;
  std::vector<warp::Image> kept_;
};

Cost report(const char* what, std::vector<Cost> costs, std::size_t frames) {
  const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::nth_element(costs.begin(), middle, costs.end(),
                   [](const Cost& a, const Cost& b) { return a.wall_s < b.wall_s; });
  const auto count = static_cast<double>(frames);
  const auto ms = [count](double seconds) { return 1e3 * seconds / count; };
  std::printf("%-12s %7.1f frames/s; a frame: %6.1f ms, CPU %6.1f ms ours, %6.1f ms ffmpeg\n", what,
              count / middle->wall_s, ms(middle->wall_s), ms(middle->own_s), ms(middle->children_s));
  return *middle;
}

void compare(const char* project, const char* output, int repetitions) {
  Job job(project, output);
  std::vector<Cost> whole, render, codec;
  whole.push_back(cost_of([&] { job.whole(); }));
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  std::printf("largest resident size of the whole job: %.0f MB\n", static_cast<double>(usage.ru_maxrss) / 1024);
  job.keep_frames();
  whole.clear();
  for (int i = 0; i < repetitions; ++i) {
    whole.push_back(cost_of([&] { job.whole(); }));
    codec.push_back(cost_of([&] { job.codec_alone(); }));
    render.push_back(cost_of([&] { job.render_alone(); }));
  }
  const Cost all = report("whole job", whole, job.count());
  const Cost alone = report("codec alone", codec, job.count());
  report("render alone", render, job.count());
  std::printf("rate of the whole job: %.0f %% of the codec alone's; by CPU time %.0f %%\n",
              100 * alone.wall_s / all.wall_s, 100 * (alone.own_s + alone.children_s) / (all.own_s + all.children_s));
}

}  // namespace
}  // namespace morphkit::job

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: bench_pipeline PROJECT OUT [repetitions]\n");
    return 2;
  }
  try {
    morphkit::job::compare(argv[1], argv[2], argc > 3 ? std::max(1, std::atoi(argv[3])) : 3);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pipeline: %s\n", error.what());
    return 1;
  }
  return 0;
}
