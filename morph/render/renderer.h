#pragma once
// A frame is a pure function of (project, frame number). Everything that frames share is prepared once.

#include <functional>
#include <vector>

#include "morph/media/frame_sink.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/inbetween.h"
#include "morph/render/placement.h"
#include "warp/analysis.h"
#include "warp/image.h"

namespace morphkit::render {

enum class SideName { kSource, kDestination };

/// The two pictures (and the background) of a project, loaded.
struct Pictures {
  media::Picture source, destination;
  std::optional<media::Picture> background;
};

/// Loads what the project names. @throws Error as media::read_picture.
Pictures load_pictures(const project::Project& project);

/// Renders moments of one project. Immutable: any number of threads may render at once.
class Renderer {
 public:
  Renderer(project::Project project, Pictures pictures);

  cv::Size size() const noexcept;   ///< of the canvas, px
  bool has_alpha() const noexcept;  ///< whether a frame may be transparent

  /// t of a frame number: 0 at the first, 1 at the last; 0 if there is only one.
  double time_of(int frame) const noexcept;

  /// The frame at t in [0, 1]; parallel over rows. t = 0 and 1 give the pictures bit for bit where the canvas is their
  /// size and nothing lies behind them.
  warp::Image frame(double t) const;

  /// Source positions, px of that side's image, for every canvas pixel at t.
  warp::Map map(double t, SideName side) const;

  const project::Project& project() const noexcept;
  const std::vector<LinePair>& pairs() const noexcept;
};

/// What `run` tells its watcher after each frame.
struct Progress {
  int done = 0, skipped = 0, total = 0;
  int frame = 0;
};

struct RunOptions {
  std::vector<int> frames;  ///< frame numbers, rising
  bool resume = false;      ///< skip frames that are already there
  int in_flight = 0;        ///< frames alive at once; 0: from the memory a frame needs
  std::function<void(const Progress&)> on_progress;
  std::function<bool()> cancelled;
};

/// Renders frames into a sink. @return what was done. @throws Error kInterrupted if cancelled before the end, after the
/// frames in work were finished.
Progress run(const Renderer& renderer, media::FrameSink& sink, const RunOptions& options);

}  // namespace morphkit::render
