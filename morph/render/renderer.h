#pragma once
// A frame is a pure function of (project, frame number). What frames share is prepared once.

#include <memory>
#include <optional>
#include <span>

#include "morph/project/evaluate.h"
#include "morph/project/project.h"
#include "morph/render/stage.h"
#include "morph/render/warper.h"
#include "warp/image/image.h"

namespace morphkit::render {

struct RendererOptions {
  bool allow_folds = false;  ///< render meshes that fold as far as possible instead of refusing them
};

/// Renders moments of one project. Immutable: any number of threads may render at once.
class Renderer {
 public:
  /// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds without allow_folds.
  Renderer(const project::Project& project, const Footage& footage, const RendererOptions& options = {});

  /// Uses an existing stage, for instance a view of the canvas; renderers may share it.
  /// @param stage  of a project that has the same pictures and output, and the same border.
  Renderer(project::Project project, std::shared_ptr<const Stage> stage, const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;

  cv::Size size() const noexcept { return stage().size; }  ///< of the canvas, px
  /// Whether a frame may be transparent; true if only the stage is known.
  bool has_alpha() const noexcept { return has_alpha_; }
  const project::Project& project() const noexcept { return body_->project; }
  const Stage& stage() const noexcept { return *body_->stage; }

  const project::Clock& clock() const noexcept { return body_->moments.clock(); }
  project::Time time_of(int frame) const noexcept { return clock().at_frame(frame); }
  project::Moment moment(project::Time time) const { return body_->moments.at(time); }
  /// The warp of a moment; the renderer outlives it. Does not throw for a moment that `require` refuses.
  std::unique_ptr<Warper> warper(project::Time time) const { return plan_->at(moment(time)); }

  cv::Size picture_size(SideIndex side) const noexcept { return stage().sides[side].file_size; }  ///< of the file, px
  const Placement& placement(SideIndex side) const noexcept { return stage().sides[side].file; }

  /// @throws Error kBadInput if the moment cannot be rendered, naming the obstacle. Cost: O(vertices).
  void require(project::Time time) const { plan_->require(moment(time)); }

  /// The frame of a moment; parallel over rows. t = 0 and 1 give the pictures bit for bit where the canvas has
  /// their size and nothing shows behind them. Memory: frame_bytes(). @throws Error as `require`.
  warp::Image frame(project::Time time) const;

  /// One picture as the frame shows it, without the others and without the background. @throws Error as `require`.
  warp::Image side(project::Time time, SideIndex side) const;

  /// Memory of one call of `frame`, including its result.
  std::size_t frame_bytes() const;

  /// Whether the frame shows anything of that side's picture, if the others cover the canvas.
  bool shows(SideIndex side, project::Time time) const { return plan_->weights(moment(time))[side].shows(); }

  /// Positions in that side's picture for every canvas pixel. Folds of lines are kept; folded parts of a mesh
  /// are squashed, as in the frame.
  warp::Map map(project::Time time, SideIndex side, Pixels pixels = Pixels::kFile) const {
    return warper(time)->map(side, pixels);
  }

  /// A few words that describe the method, for logs.
  std::string description() const { return warper(clock().at(0))->label(); }

 private:
  /// The plan refers to these: their addresses stay when the renderer moves.
  struct Body {
    project::Evaluator moments;
    project::Project project;
    std::shared_ptr<const Stage> stage;
  };

  std::unique_ptr<const Body> body_;
  std::unique_ptr<const Plan> plan_;
  bool has_alpha_ = true;
};

}  // namespace morphkit::render
