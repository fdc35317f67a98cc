#pragma once
// The result pane: the visible part of one moment of the morph, at the size on screen.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "cli/edit/view/model.h"
#include "cli/edit/view/pyramid.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

struct PreviewRequest {
  std::shared_ptr<const project::Project> project;
  double t = 0;
  Show show = Show::kDissolve;
  bool folds = false;        ///< paint them red
  View view;                 ///< of the canvas that is rendered
  cv::Size size;             ///< of the pane, px
  std::uint64_t number = 0;  ///< returned with the picture
};

struct PreviewPicture {
  cv::Mat3b image;  ///< BGR for the screen, to be shown at the size of `area`; empty: there is none
  cv::Rect area;    ///< of the pane, px: where the canvas that is rendered can be seen
  double fold_share = std::numeric_limits<double>::quiet_NaN();  ///< of the pixels shown; NaN if not looked for
  bool draft = false;                                            ///< a sharper one follows
  std::uint64_t number = 0;                                      ///< of its request
  std::string problem;                                           ///< why there is none; empty if there is one
  double milliseconds = 0;                                       ///< that it took
};

/// Renders previews, and keeps what many of them share: the pictures, placed and reduced for the view. Not thread-safe.
class PreviewRenderer {
 public:
  /// The pyramids outlive it. @param background  null: the project has no background picture.
  PreviewRenderer(const Pyramid& source, const Pyramid& destination, const Pyramid* background = nullptr)
      : source_(source), destination_(destination), background_(background) {}

  /// @param reduction  1: as many px as the pane has; n: one for n x n of them, and `draft` is set.
  /// What cannot be rendered is told in `problem`.
  PreviewPicture render(const PreviewRequest& request, int reduction = 1);

 private:
  struct Placed {
    render::CanvasView view;
    std::optional<warp::Border> border;
    project::Output output;
    std::shared_ptr<const render::Stage> stage;
  };

  const std::shared_ptr<const render::Stage>& stage_of(const PreviewRequest& request, const cv::Rect& area,
                                                       int reduction);

  const Pyramid& source_;
  const Pyramid& destination_;
  const Pyramid* background_;
  std::optional<Placed> placed_, placed_draft_;  ///< kept apart, so that drafts do not evict it
};

}  // namespace morphkit::edit
