#pragma once
// The two pictures of a project, placed on the canvas: what every warper starts from.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/placement.h"
#include "warp/image/image.h"
#include "warp/sample/sample.h"

namespace morphkit::render {

using project::kDestination;
using project::kSource;
using project::SideIndex;

/// "source" or "destination".
const char* name_of(SideIndex side);

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
  cv::Size size;                 ///< of the canvas, or of the view of it that is rendered, px
  double unit = 1;               ///< canvas px per px of the view
  std::vector<StageSide> sides;  ///< in the order of the pictures
  warp::Image behind;            ///< what lies behind the morph. Empty: nothing; 1 x 1: a colour; else of `size`
};

Stage make_stage(const project::Project& project, const Pictures& pictures);

/// A part of the canvas, reduced or magnified: view px = (canvas px - origin) * zoom.
struct CanvasView {
  cv::Size size;  ///< px
  double zoom = 1;
  cv::Point2d origin;  ///< canvas px
};

/// A picture's own size and, for a number of px that its pixel is to be shown at, what to start from: the picture, or a
/// smaller copy that is still at least as large as shown.
struct ScaledPicture {
  cv::Size size;
  std::function<warp::Image(double scale)> at;
};

/// A stage that shows a view: what is rendered on it is what lies there on the whole canvas. Copies of more than
/// kReducedAreaPx are taken as they are, which costs more time per frame than reducing them but once less.
/// @param pictures    in the order of the project's. @param background  nothing: there is no background picture.
Stage make_stage(const project::Project& project, std::span<const ScaledPicture> pictures,
                 const std::optional<ScaledPicture>& background, const CanvasView& view);

inline constexpr int kReducedAreaPx = 6'000'000;

}  // namespace morphkit::render
