#pragma once
// A frame is a pure function of (project, frame number). Everything that frames share is prepared once.

#include <memory>
#include <optional>
#include <span>

#include "morph/project/project.h"
#include "morph/render/morpher.h"
#include "morph/render/stage.h"
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
  ~Renderer();
  Renderer(Renderer&&) noexcept;

  cv::Size size() const noexcept { return body_->stage.size; }  ///< of the canvas, px
  bool has_alpha() const noexcept { return has_alpha_; }        ///< whether a frame may be transparent
  const project::Project& project() const noexcept { return body_->project; }
  const Stage& stage() const noexcept { return body_->stage; }

  /// t of a frame number: 0 at the first, 1 at the last; 0 if there is only one.
  double time_of(int frame) const noexcept;

  cv::Size picture_size(SideIndex side) const noexcept { return stage().side(side).file_size; }  ///< of the file, px
  const Placement& placement(SideIndex side) const noexcept { return stage().side(side).file; }

  /// @throws Error kBadInput if the moment t cannot be rendered, naming what is in the way. Cost: O(vertices).
  void require(double t) const { morpher_->require(t); }

  /// The frame at t in [0, 1]; parallel over rows. t = 0 and 1 give the pictures bit for bit where the canvas has
  /// their size and nothing shows behind them. Memory: frame_bytes(). @throws Error as `require`.
  warp::Image frame(double t) const;

  /// What one call of `frame` takes, its result included.
  std::size_t frame_bytes() const;

  /// Whether anything of that side's picture is in the frame at t, if the other one covers the canvas.
  bool shows(SideIndex side, double t) const { return morpher_->shows(side, t); }

  /// Source positions for every canvas pixel at t, px of that side's image file.
  warp::Map map(double t, SideIndex side) const { return morpher_->map(t, side); }

  /// What does the work, in a few words for --verbose.
  std::string description() const { return morpher_->description(); }

 private:
  /// What the morpher refers to: stays where it is when the renderer moves.
  struct Body {
    project::Project project;
    Stage stage;
  };

  void make_background(const std::optional<media::Picture>& picture);

  std::unique_ptr<const Body> body_;
  std::unique_ptr<const Morpher> morpher_;
  bool has_alpha_ = false;
  warp::Image background_;  ///< empty: nothing behind; 1x1: a colour; else of canvas size
};

}  // namespace morphkit::render
