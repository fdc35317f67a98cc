#include "cli/cmd_morph.h"

#include <memory>

#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {
namespace {

void add_options(Options& command, MorphOptions& options) {
  command.paths("PROJECT", options.inputs, "A project file, or two pictures", "| A B", 2).required();
  command
      .path("-o,--output", options.output,
            "frame.%04d.png or frame.####.exr for frames; .mp4 .webm .mkv .mov .gif .apng; with -t a picture", "OUT")
      .required();
  command.path("--features", options.features, "Features for two pictures: a project file, or its features alone", "F");
  command.text("--frames", options.frames, "Only these frames: 1-240, 1-240x2, 1,5,9-12, 10-", "RANGE");
  command.real("-t,--time", options.t, "One picture at this moment, 0 (source) to 1 (destination)", "T");
  command.integer("-n,--frame-count", options.frame_count, "Number of frames from first to last", "N", {1, 10'000'000});
  command.text("--size", options.size, "Size of the output in pixels", "WxH");
  command.choice("--fit", options.fit, "How pictures of another size are placed: contain, cover, stretch, none", "FIT",
                 words_of(fit_names()));
  command.choice("--filter", options.filter,
                 "How colours are found: area (default), mitchell, lanczos, bicubic, bilinear, nearest", "FILTER",
                 words_of(filter_names()));
  command.choice("--field", options.field, "How the field of lines is evaluated: adaptive (default), exact", "FIELD",
                 words_of(field_names()));
  command.text("--fps", options.fps, "Frames per second of a video: 25, 29.97, 30000/1001", "RATE");
  command.text("--depth", options.depth, "Bits of frame files: 8, 16, half, float", "DEPTH");
  command.integer("--quality", options.quality, "JPEG and WebP: 1 to 100; videos: CRF, lower is better", "Q", {0, 100});
  command.integer("--compression", options.compression,
                  "PNG, TIFF, EXR, APNG: 0 (none) to 9 (smallest); fast if not given", "N", {0, 9});
  command.text("--preset", options.preset,
               "How long the encoder may think: .mp4 ultrafast ... veryfast ... placebo; .webm realtime, good, best",
               "NAME");
  command.flag("--allow-folds", options.allow_folds, "Render a mesh that folds over as far as that goes");
  command.flag("--resume", options.resume, "Render only the frames that are not there yet");
  command.flag("-y,--overwrite", options.overwrite, "Replace files that exist");
  command.flag("--json", options.json, "Print what was done as JSON");
}

}  // namespace

void add_morph(CommandLine& line, Session& session) {
  auto options = std::make_shared<MorphOptions>();
  Options command = add_command(line, session,
                                {"morph", "Render a morph: numbered frames, a video, an animation or one picture",
                                 "  morphkit morph pair.json -o out.mp4\n"
                                 "  morphkit morph a.jpg b.jpg --features pair.json -o frame.%04d.png\n"
                                 "  morphkit morph pair.json --frames 1-240x2 --resume -o frame.####.exr\n"
                                 "  morphkit morph pair.json -t 0.5 -o middle.png",
                                 kRenderGroup},
                                work_of(session, &Works::morph, options));
  add_options(command, *options);
}

}  // namespace morphkit::cli
