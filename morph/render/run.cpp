#include "morph/render/run.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "morph/error.h"
#include "warp/parallel.h"

namespace morphkit::render {
namespace {

/// What the frames in flight may take together: enough for two 4K float frames with what their codec holds.
constexpr std::size_t kFrameMemoryBytes = std::size_t{512} << 20;

int frames_in_flight(const RunOptions& options, const Renderer& renderer) {
  if (options.in_flight > 0) return options.in_flight;
  // A float frame, and its encoded form at up to 16 bit per channel.
  const std::size_t frame_bytes = renderer.frame_bytes() + static_cast<std::size_t>(renderer.size().area()) * 8;
  const std::size_t fit = std::max<std::size_t>(1, kFrameMemoryBytes / frame_bytes);
  return static_cast<int>(std::min<std::size_t>(fit, static_cast<std::size_t>(warp::threads()) + 1));
}

}  // namespace

Progress run(const Renderer& renderer, media::FrameSink& sink, const RunOptions& options) {
  Progress progress;
  progress.total = static_cast<int>(options.frames.size());
  std::vector<int> missing;
  for (const int frame : options.frames)
    if (options.resume && sink.has(frame))
      ++progress.skipped;
    else
      missing.push_back(frame);

  // A morph that cannot be rendered to its end is not begun.
  for (const int frame : missing) renderer.require(renderer.time_of(frame));

  warp::PipelineStages stages;
  stages.make = [&](std::int64_t index) -> std::shared_ptr<void> {
    const int frame = missing[static_cast<std::size_t>(index)];
    return std::make_shared<media::FrameSink::Packet>(sink.encode(frame, renderer.frame(renderer.time_of(frame))));
  };
  stages.deliver = [&](std::int64_t index, const std::shared_ptr<void>& item) {
    progress.frame = missing[static_cast<std::size_t>(index)];
    sink.write(progress.frame, std::move(*std::static_pointer_cast<media::FrameSink::Packet>(item)));
    ++progress.done;
    if (options.on_progress) options.on_progress(progress);
  };
  const auto cancelled = [&] { return options.cancelled && options.cancelled(); };
  warp::run_pipeline(static_cast<std::int64_t>(missing.size()), frames_in_flight(options, renderer), stages, cancelled);
  if (progress.done < static_cast<int>(missing.size()))
    throw Error(ErrorCode::kInterrupted, "",
                fmt::format("interrupted after {} of {} frames", progress.done + progress.skipped, progress.total));
  sink.finish();
  return progress;
}

}  // namespace morphkit::render
