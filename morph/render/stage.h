#pragma once
// The pictures of a project, placed on the canvas: the input of every warper.

#include <optional>
#include <vector>

#include "morph/project/project.h"
#include "morph/render/footage.h"
#include "morph/render/placement.h"
#include "warp/image/image.h"
#include "warp/sample/sample.h"

namespace morphkit::render {

using project::kDestination;
using project::kSource;
using project::SideIndex;

/// "source" or "destination".
const char* name_of(SideIndex side);

/// The canvas that a project renders to, px: its output.size, or the size of the first picture.
cv::Size canvas_size(const project::Project& project, cv::Size first_picture);

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

/// A part of the canvas, reduced or magnified: view px = (canvas px - origin) * zoom.
struct CanvasView {
  cv::Size size;  ///< px
  double zoom = 1;
  cv::Point2d origin;  ///< canvas px
};

/// A stage that shows the whole canvas or a view of it; a view shows exactly that part of the canvas. For a view,
/// copies above kReducedAreaPx are used unreduced: each frame takes longer, but making the stage is quick.
/// @throws std::invalid_argument if there are not as many pictures as the project has.
Stage make_stage(const project::Project& project, const Footage& footage,
                 const std::optional<CanvasView>& view = std::nullopt);

inline constexpr int kReducedAreaPx = 6'000'000;

}  // namespace morphkit::render
