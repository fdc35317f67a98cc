#pragma once
// A frame is a pure function of (project, frame number). Everything that frames share is prepared once.

#include <memory>
#include <optional>
#include <span>

#include "morph/project/clock.h"
#include "morph/project/project.h"
#include "morph/render/stage.h"
#include "morph/render/warper.h"
#include "warp/image/image.h"

namespace morphkit::render {

struct RendererOptions {
  bool allow_folds = false;  ///< render meshes that fold as far as that goes, instead of refusing
};

/// Renders moments of one project. Immutable: any number of threads may render at once.
class Renderer {
 public:
  /// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds and must not.
  Renderer(project::Project project, const Pictures& pictures, const RendererOptions& options = {});

  /// On a stage that is there already, such as one that shows a view of the canvas; renderers may share it.
  /// @param stage  of a project that has the same pictures and output, and the same border.
  Renderer(project::Project project, std::shared_ptr<const Stage> stage, const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;

  cv::Size size() const noexcept { return stage().size; }  ///< of the canvas, px
  /// Whether a frame may be transparent; true if only the stage is known.
  bool has_alpha() const noexcept { return has_alpha_; }
  const project::Project& project() const noexcept { return body_->project; }
  const Stage& stage() const noexcept { return *body_->stage; }

  project::Clock clock() const noexcept { return project::Clock(project().output); }
  double time_of(int frame) const noexcept { return clock().at_frame(frame).t; }

  cv::Size picture_size(SideIndex side) const noexcept { return stage().sides[side].file_size; }  ///< of the file, px
  const Placement& placement(SideIndex side) const noexcept { return stage().sides[side].file; }

  /// @throws Error kBadInput if the moment t cannot be rendered, naming what is in the way. Cost: O(vertices).
  void require(double t) const { plan_->require(t); }

  /// The frame at t in [0, 1]; parallel over rows. t = 0 and 1 give the pictures bit for bit where the canvas has
  /// their size and nothing shows behind them. Memory: frame_bytes(). @throws Error as `require`.
  warp::Image frame(double t) const;

  /// One picture at t as the frame shows it, without the others and without the background. @throws Error as `require`.
  warp::Image side(double t, SideIndex side) const;

  /// What one call of `frame` takes, its result included.
  std::size_t frame_bytes() const;

  /// Whether anything of that side's picture is in the frame at t, if the other one covers the canvas.
  bool shows(SideIndex side, double t) const { return plan_->dissolve(t).shows(side); }

  /// Positions in that side's picture for every canvas pixel at t. Folds of lines show as they are; what is out of
  /// order in a mesh is squashed, as in the frame.
  warp::Map map(double t, SideIndex side, Pixels pixels = Pixels::kFile) const {
    return plan_->at(t)->map(side, pixels);
  }

  /// What does the work, in a few words for --verbose.
  std::string description() const { return plan_->label(); }

 private:
  /// What the plan refers to: stays where it is when the renderer moves.
  struct Body {
    project::Project project;
    std::shared_ptr<const Stage> stage;
  };

  std::unique_ptr<const Body> body_;
  std::unique_ptr<const Plan> plan_;
  bool has_alpha_ = true;
};

}  // namespace morphkit::render
