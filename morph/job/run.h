#pragma once
// Frames of a renderer into a sink: ranges, resuming, several frames in work at once, bounded memory.

#include <functional>
#include <vector>

#include "morph/job/pictures.h"
#include "morph/media/frame_sink.h"
#include "morph/render/renderer.h"

namespace morphkit::job {

/// What `run` tells its watcher after each frame, and in the end.
struct Progress {
  int done = 0;     ///< frames rendered
  int skipped = 0;  ///< frames that were already there
  int total = 0;    ///< frames asked for
  int frame = 0;    ///< number of the frame just finished
  int renewed = 0;  ///< frames whose files are damaged or were made from something else, among those to render
};

struct RunOptions {
  std::vector<int> frames;  ///< frame numbers, rising
  bool resume = false;      ///< skip frames that are whole and made from the same
  int in_flight = 0;        ///< frames alive at once; 0: as many as keep the threads busy and memory allows
  std::function<void(const Progress&)> on_progress;
  std::function<bool()> cancelled;
};

/// What a sink must know of the frames: size, rate, whether they may be transparent, the metadata of the first picture,
/// which they inherit, and what each is made from: the document without paths, the bytes of its pictures and the time.
/// What people choose is left at its defaults.
media::SinkOptions sink_options(const render::Renderer& renderer, const Pictures& pictures);

/// Renders frames into a sink and finishes it. Frames are encoded while others are rendered and reach the sink in
/// order, on a thread that does nothing else. Memory: the pictures and `in_flight` frames, whatever the number of
/// frames: threads + 1 in the making, fewer if they do not fit into a sixteenth of the machine's memory (or 512 MiB),
/// and two encoded ones.
/// @throws Error kInterrupted if cancelled before the end, after the frames in work were delivered.
Progress run(const render::Renderer& renderer, media::FrameSink& sink, const RunOptions& options);

}  // namespace morphkit::job
