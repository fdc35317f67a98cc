#include "cli/cmd_morph.h"

#include <memory>

#include "cli/command.h"
#include "cli/works.h"

namespace morphkit::cli {
namespace {

void add_options(Options& command, MorphOptions& options) {
  command
      .path("-o,--output", options.output,
            "frame.%04d.png or frame.####.exr for frames; .mp4 .webm .mkv .mov .gif .apng; with -t a picture", "OUT")
      .required();
  declare_project(command, options.project,
                  {KeyOption::kFrameCount, KeyOption::kSize, KeyOption::kFit, KeyOption::kFilter, KeyOption::kField,
                   KeyOption::kFps});
  command.text("--frames", options.frames, "Only these frames: 1-240, 1-240x2, 1,5,9-12, 10-", "RANGE");
  command.real("-t,--time", options.t, "One picture at this moment, 0 (source) to 1 (destination)", "T");
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
                                 "  morphkit morph pair.json -t 0.5 -o middle.png\n"
                                 "  morphkit morph pair.json --set warp.b=1.5 --set output.fit=contain -o out.mp4",
                                 kRenderGroup},
                                work_of(session, &Works::morph, options));
  add_options(command, *options);
}

}  // namespace morphkit::cli
