#include "cli/cmd_map.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/stop.h"
#include "cli/arguments.h"
#include "cli/cmd_morph.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/frame_range.h"
#include "cli/interrupt.h"
#include "cli/terminal.h"
#include "morph/job/pictures.h"
#include "morph/media/frame_pattern.h"
#include "morph/media/image_file.h"
#include "morph/render/renderer.h"
#include "morph/render/stmap.h"

namespace morphkit::cli {
namespace {

void write_moment(const MapOptions& options, const render::Renderer& renderer, project::Time time,
                  const std::filesystem::path& file) {
  const project::SideIndex side = options.side == "destination" ? project::kDestination : project::kSource;
  const render::Origin origin = options.origin == "top-left" ? render::Origin::kTopLeft : render::Origin::kBottomLeft;
  renderer.require(time);
  media::write_map(file, render::stmap(renderer.map(time, side), renderer.picture_size(side), origin),
                   options.overwrite);
}

int write_frames(const MapOptions& options, const render::Renderer& renderer, Output& output) {
  const project::Clock clock = renderer.clock();
  const std::vector<int> frames = parse_frame_range(options.frames, clock.first(), clock.last());
  const media::FramePattern pattern(options.output);
  ProgressBar bar(output, "maps");
  int done = 0;
  for (const int frame : frames) {
    try {
      stop_if_asked();
      write_moment(options, renderer, renderer.time_of(frame), pattern(frame));
    } catch (const Error&) {
      stop_if_interrupted(fmt::format("{} of {} maps were written", done, frames.size()));
      throw;
    }
    bar.update(++done, 0, static_cast<int>(frames.size()));
  }
  return 0;
}

}  // namespace

int run_map(const MapOptions& options, Output& output) {
  const StopScope stopping(interrupted);
  if (options.t.has_value() == !options.frames.empty())
    throw ArgumentError("map", "give either a moment (-t 0.5) or frames (--frames 1-48)");
  if (options.t) require_moment(*options.t);
  const project::Project project = load_project(options.project);
  warn_of_unused_settings(project, output);
  const render::Renderer renderer(project, job::footage_of(job::load_pictures(project)),
                                  {.allow_folds = options.allow_folds});
  output.detail(canvas_note(renderer));
  if (!options.t) return as_asked([&] { return write_frames(options, renderer, output); });
  as_asked([&] { write_moment(options, renderer, renderer.clock().at(*options.t), options.output); });
  output.note(fmt::format("{}: {}x{}", options.output.string(), renderer.size().width, renderer.size().height));
  return 0;
}

}  // namespace morphkit::cli
