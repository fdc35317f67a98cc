#pragma once
// The two pictures of a project, placed on the canvas: what every morpher starts from.

#include <optional>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/placement.h"
#include "warp/image.h"
#include "warp/sample.h"

namespace morphkit::render {

enum class SideName { kSource, kDestination };

/// "source" or "destination".
const char* name_of(SideName side);

/// The two pictures (and the background) of a project, loaded.
struct Pictures {
  media::Picture source, destination;
  std::optional<media::Picture> background;
};

/// Loads what the project names. @throws Error as media::read_picture.
Pictures load_pictures(const project::Project& project);

/// The canvas that a project renders to, px: its output.size, or the size of the source picture.
cv::Size canvas_size(const project::Project& project, cv::Size source_picture);

/// One picture, ready for warping. A picture larger than its place on the canvas is reduced once, by area averaging;
/// `file` places the picture as it is in the file, `held` as it is held in memory.
struct StageSide {
  warp::Image image;
  cv::Size file_size;
  Placement file, held;
  warp::Border border = warp::Border::kClamp;  ///< kTransparent or what the project says
};

struct Stage {
  cv::Size size;  ///< of the canvas, px
  StageSide source, destination;

  const StageSide& side(SideName name) const noexcept { return name == SideName::kSource ? source : destination; }
};

Stage make_stage(const project::Project& project, const Pictures& pictures);

}  // namespace morphkit::render
