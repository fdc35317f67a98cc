#include "cli/cmd_morph.h"

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/stop.h"
#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/frame_range.h"
#include "cli/interrupt.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "morph/job/pictures.h"
#include "morph/job/run.h"
#include "morph/media/frame_sink.h"
#include "morph/media/image_file.h"
#include "morph/render/renderer.h"

namespace morphkit::cli {
namespace {

void say_what_was_read(const project::Project& project, const job::Pictures& pictures, Output& output) {
  warn_of_pixels(project, pictures, output);
  warn_of_unused_settings(project, output);
  if (project::method_name_of(project) != project::MethodName::kLines) return;
  if (const std::string note = unused_mesh_note(project); !note.empty())
    output.warning(note);
  else if (project.features.empty())
    output.warning(
        "there are no features, so this is a plain dissolve. To bend one picture into the other, mark what "
        "corresponds: 'morphkit edit' opens a window for that; 'morphkit demo' writes a project file to copy from");
}

media::SinkOptions sink_options(const MorphOptions& options, const render::Renderer& renderer,
                                const job::Pictures& pictures) {
  media::SinkOptions sink = job::sink_options(renderer, pictures);
  sink.image.depth = media::depth_from(options.depth);
  sink.image.compression = options.compression;
  sink.preset = options.preset;
  // Resuming replaces files that have a frame's name but are damaged or made from something else.
  sink.image.overwrite = options.overwrite || options.resume;
  if (options.quality >= 0) sink.image.quality = sink.video_quality = options.quality;
  return sink;
}

void refuse_to_overwrite(const media::FrameSink& sink, const std::vector<int>& frames, const MorphOptions& options) {
  if (options.overwrite || options.resume) return;
  const std::vector<std::filesystem::path> existing = sink.existing(frames);
  if (existing.empty()) return;
  throw Error(ErrorKind::kIo, existing.front().string(),
              fmt::format("exists{}; use --overwrite to replace, or --resume to render only what is missing",
                          existing.size() > 1 ? fmt::format(", and {} more", existing.size() - 1) : ""));
}

std::string size_text(cv::Size size) {
  return fmt::format("{}x{}", size.width, size.height);
}

void say_what_was_done(const MorphOptions& options, const render::Renderer& renderer, const job::Progress& done,
                       double elapsed_s, Output& output) {
  if (options.json) {
    Report report;
    report.set("output", options.output.string()).set("width", renderer.size().width);
    report.set("height", renderer.size().height).set("frames", done.done).set("skipped", done.skipped);
    report.set("renewed", done.renewed);
    report.set("seconds", elapsed_s);
    output.line(report.to_json());
    return;
  }
  output.note(fmt::format("{}: {} {} of {}{} in {:.1f} s", options.output.string(), done.done,
                          done.done == 1 ? "frame" : "frames", size_text(renderer.size()),
                          done.skipped > 0 ? fmt::format(", {} were there already,", done.skipped) : "", elapsed_s));
}

int render_moment(const MorphOptions& options, const render::Renderer& renderer, const media::SinkOptions& sink,
                  Output& output) {
  if (!options.preset.empty()) throw ArgumentError("--preset", "is for .mp4 and .webm; one picture has no presets");
  media::check_write_options(options.output, sink.image);
  const auto start = std::chrono::steady_clock::now();
  media::write_image(options.output, renderer.frame(renderer.clock().at(*options.t)), sink.image);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  say_what_was_done(options, renderer, {1, 0, 1, 0, 0}, elapsed.count(), output);
  return 0;
}

int render_frames(const MorphOptions& options, const render::Renderer& renderer, media::SinkOptions sink_options,
                  Output& output) {
  const int first = renderer.clock().first(), last = renderer.clock().last();
  job::RunOptions run;
  run.frames =
      parse_frame_range(options.frames.empty() ? fmt::format("{}-{}", first, last) : options.frames, first, last);
  run.resume = options.resume;
  run.cancelled = interrupted;
  sink_options.frames = run.frames;
  if (options.resume && media::is_complete_video(options.output, sink_options)) {
    say_what_was_done(options, renderer, {0, static_cast<int>(run.frames.size()), 0, 0, 0}, 0, output);
    return 0;
  }
  const auto sink = media::open_sink(options.output, sink_options, run.frames.size() == 1);
  refuse_to_overwrite(*sink, run.frames, options);

  const auto start = std::chrono::steady_clock::now();
  job::Progress done;
  {
    ProgressBar bar(output, "frames");
    run.on_progress = [&](const job::Progress& p) { bar.update(p.done, p.skipped, p.total); };
    done = job::run(renderer, *sink, run);
  }
  if (done.renewed > 0)
    output.warning(fmt::format("{} of {} frames were damaged or made from something else: rendered anew", done.renewed,
                               done.total));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  say_what_was_done(options, renderer, done, elapsed.count(), output);
  return 0;
}

}  // namespace

void warn_of_pixels(const std::filesystem::path& file, const media::Picture& picture, Output& output) {
  for (const std::string& sentence : media::warnings_of(picture))
    output.warning(fmt::format("{}: {}", file.string(), sentence));
}

void warn_of_pixels(const project::Project& project, const job::Pictures& pictures, Output& output) {
  for (std::size_t side = 0; side < pictures.sides.size(); ++side)
    warn_of_pixels(project.pictures[side].image, pictures.sides[side], output);
  if (const auto* background = std::get_if<std::filesystem::path>(&project.output.background); pictures.background)
    warn_of_pixels(*background, *pictures.background, output);
}

void warn_of_unused_settings(const project::Project& project, Output& output) {
  for (const std::string& sentence : project::unused_settings(project)) output.warning(sentence);
}

std::string canvas_note(const render::Renderer& renderer) {
  return fmt::format("canvas {}, {}", size_text(renderer.size()), renderer.description());
}

std::string unused_mesh_note(const project::Project& project) {
  if (!project.mesh || project::method_name_of(project) == project::MethodName::kMesh) return "";
  return "the mesh is not used, for the method is lines; \"warp\": {\"method\": \"mesh\"} would use it";
}

int run_morph(const MorphOptions& options, Output& output) {
  if (options.t) require_moment(*options.t);
  if (options.t && !options.frames.empty()) throw ArgumentError("-t", "is one moment; it does not go with --frames");
  if (options.resume && options.overwrite)
    throw ArgumentError("--resume", "keeps what is there and --overwrite replaces it; choose one");
  std::optional<StopScope> stopping(std::in_place, interrupted);
  const project::Project project = load_project(options.project);
  const job::Pictures pictures = job::load_pictures(project);
  say_what_was_read(project, pictures, output);
  const render::Renderer renderer(project, job::footage_of(pictures), {.allow_folds = options.allow_folds});
  output.detail(canvas_note(renderer));
  if (!options.t) stopping.reset();  // frames in work are finished
  return as_asked([&] {
    const media::SinkOptions sink = sink_options(options, renderer, pictures);
    return options.t ? render_moment(options, renderer, sink, output) : render_frames(options, renderer, sink, output);
  });
}

}  // namespace morphkit::cli
