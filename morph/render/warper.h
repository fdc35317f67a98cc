#pragma once
// Where the pixels of a moment come from. One implementation per method.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "morph/project/project.h"
#include "morph/render/stage.h"
#include "warp/image/image.h"

namespace morphkit::render {

/// The moments at which a morph is looked at before it is rendered.
inline constexpr double kMoments[] = {0, 0.25, 0.5, 0.75, 1};

/// Which pixels of a picture positions are measured in.
enum class Pixels {
  kHeld,  ///< of the picture as the stage holds it: what is sampled
  kFile   ///< of the image file
};

/// The least and the most that any pixel of a frame is dissolved, in [0, 1].
struct DissolveRange {
  double least = 0, most = 0;

  bool is_local() const noexcept { return least != most; }
  bool shows(SideIndex side) const noexcept { return side == kSource ? least < 1 : most > 0; }
};

/// The warp of one moment. Immutable: any number of threads may use one at once. The stage and the plan that made it
/// outlive it.
class Warper {
 public:
  virtual ~Warper() = default;
  Warper(const Warper&) = delete;
  Warper& operator=(const Warper&) = delete;

  DissolveRange dissolve() const noexcept { return dissolve_; }

  /// Positions in every picture for the canvas rows from `top` on, all sides in one pass.
  /// @param maps      one per side, as wide as the canvas, of equal heights; written through. NaN: nothing there.
  /// @param dissolve  of the same size, the progress of every pixel; null if not wanted.
  virtual void positions(int top, std::span<warp::Map> maps, Pixels pixels, cv::Mat1f* dissolve) const = 0;

  /// Positions in one picture for the whole canvas; parallel over bands.
  virtual warp::Map map(SideIndex side, Pixels pixels) const;

  /// The picture of a side warped as a whole, for methods that do not sample it at positions; else nothing.
  virtual std::optional<warp::Image> drawn(SideIndex) const { return std::nullopt; }

  /// The progress of every pixel of a canvas row, for methods that draw whole pictures.
  virtual void dissolve_row(int, std::span<float>) const {}

 protected:
  Warper(const Stage& stage, DissolveRange dissolve) : stage_(stage), dissolve_(dissolve) {}
  const Stage& stage() const noexcept { return stage_; }

 private:
  const Stage& stage_;
  DissolveRange dissolve_;
};

/// What a method knows of a whole shot. Immutable. The project and the stage outlive it.
class Plan {
 public:
  virtual ~Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  virtual std::unique_ptr<Warper> at(double t) const = 0;

  /// Of the moment t. Cost: O(features) or O(vertices).
  virtual DissolveRange dissolve(double t) const = 0;

  /// @throws Error kBadInput if the moment t cannot be rendered, naming what is in the way.
  virtual void require(double) const {}

  /// Memory that a frame takes beside its result and a few rows for every thread.
  virtual std::size_t scratch_bytes() const { return 0; }

  /// What does the work, in a few words for --verbose.
  virtual std::string label() const = 0;

 protected:
  Plan() = default;
};

/// The plan of project::method_of(project).
/// @param allow_folds  render meshes that fold as far as that goes.
/// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds and must not.
std::unique_ptr<Plan> make_plan(const project::Project& project, const Stage& stage, bool allow_folds);

}  // namespace morphkit::render
