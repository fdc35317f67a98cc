#include "morph/job/run.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/parallel.h"

namespace morphkit::job {
namespace {

/// The memory limit of all unfinished frames together: a sixteenth of the machine's memory, but enough for ten 1080p
/// frames.
std::size_t frame_memory_bytes() {
  constexpr std::size_t kLeast = std::size_t{512} << 20;
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page_bytes = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page_bytes <= 0) return kLeast;
  return std::max(kLeast, static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_bytes) / 16);
}

int frames_in_flight(const RunOptions& options, const render::Renderer& renderer) {
  if (options.in_flight > 0) return options.in_flight;
  // A float frame, and its encoded form at up to 16 bit per channel.
  const std::size_t frame_bytes = renderer.frame_bytes() + static_cast<std::size_t>(renderer.size().area()) * 8;
  // Two at least: one is encoded while the next is rendered. Codecs run on one thread each, so one frame for every
  // thread keeps all busy, and one more those that wait for their turn. More would only wait.
  const std::size_t fit = std::max<std::size_t>(2, frame_memory_bytes() / frame_bytes);
  const int making = static_cast<int>(std::min<std::size_t>(fit, static_cast<std::size_t>(threads()) + 1));
  int in_flight = making;
  while (made_at_once(in_flight) < making) ++in_flight;
  return in_flight;
}

std::string text_without_paths(project::Project project) {
  project.original.reset();
  project.file.clear();
  for (project::Picture& picture : project.pictures) picture.image = "picture";
  if (std::holds_alternative<std::filesystem::path>(project.output.background))
    project.output.background = std::filesystem::path("background");
  return project::to_text(project);
}

/// Which of the frames are done. They are looked at in parallel: each is decoded.
std::vector<char> find_done(const media::FrameSink& sink, const std::vector<int>& frames) {
  std::vector<char> done(frames.size());
  for_rows(
      static_cast<int>(frames.size()),
      [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
          done[static_cast<std::size_t>(i)] = sink.has(frames[static_cast<std::size_t>(i)]);
      },
      1);
  return done;
}

}  // namespace

media::SinkOptions sink_options(const render::Renderer& renderer, const Pictures& pictures) {
  const project::Output& output = renderer.project().output;
  media::SinkOptions sink;
  sink.size = renderer.size();
  sink.fps_num = output.fps.num;
  sink.fps_den = output.fps.den;
  sink.has_alpha = renderer.has_alpha();
  sink.image.alpha = renderer.has_alpha();  // the same channels in every frame
  sink.image.metadata = pictures.sides.front().metadata;
  sink.made_from = [document = text_without_paths(renderer.project()), digest = pictures.digest,
                    clock = renderer.clock()](int frame) {
    const project::Time time = clock.at_frame(frame);
    return fmt::format("{}\n{}frame {} t {}", document, digest, time.frame, time.t);
  };
  return sink;
}

Progress run(const render::Renderer& renderer, media::FrameSink& sink, const RunOptions& options) {
  Progress progress;
  progress.total = static_cast<int>(options.frames.size());
  std::vector<int> missing;
  if (options.resume) {
    const std::vector<char> done = find_done(sink, options.frames);
    for (std::size_t i = 0; i < done.size(); ++i)
      if (done[i] == 0) missing.push_back(options.frames[i]);
    progress.skipped = static_cast<int>(options.frames.size() - missing.size());
    for (const int frame : missing) progress.renewed += sink.existing({frame}).empty() ? 0 : 1;
  } else {
    missing = options.frames;
  }

  // A morph that cannot be rendered to its end is not begun.
  for (const int frame : missing) renderer.require(renderer.time_of(frame));

  const auto make = [&](std::int64_t index) {
    const int frame = missing[static_cast<std::size_t>(index)];
    return sink.encode(frame, renderer.frame(renderer.time_of(frame)));
  };
  const auto deliver = [&](std::int64_t index, media::FrameSink::Packet packet) {
    progress.frame = missing[static_cast<std::size_t>(index)];
    sink.write(progress.frame, std::move(packet));
    ++progress.done;
    if (options.on_progress) options.on_progress(progress);
  };
  const auto cancelled = [&] { return options.cancelled && options.cancelled(); };
  run_pipeline(static_cast<std::int64_t>(missing.size()), frames_in_flight(options, renderer), make, deliver,
               cancelled);
  if (progress.done < static_cast<int>(missing.size()))
    throw Error(ErrorKind::kInterrupted, "",
                fmt::format("interrupted after {} of {} frames", progress.done + progress.skipped, progress.total));
  sink.finish();
  return progress;
}

}  // namespace morphkit::job
