#pragma once
// Where the pixels of a moment come from. One implementation per method.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "morph/project/evaluate.h"
#include "morph/render/finding.h"
#include "morph/render/stage.h"
#include "warp/image/image.h"

namespace morphkit::render {

/// The moments, as t, at which a morph is looked at before it is rendered.
inline constexpr double kMoments[] = {0, 0.25, 0.5, 0.75, 1};

/// Which pixels of a picture positions are measured in.
enum class Pixels {
  kHeld,  ///< of the picture as the stage holds it: what is sampled
  kFile   ///< of the image file
};

/// The least and the most that any pixel of a frame takes of a picture's colour, in [0, 1].
struct WeightRange {
  double least = 0, most = 0;

  bool is_local() const noexcept { return least != most; }
  bool shows() const noexcept { return most > 0; }
};

/// One per picture, over everything that a frame is made of. @pre not empty.
std::vector<WeightRange> ranges_of(std::span<const project::Weights> weights);

/// The warp of one moment. Immutable: any number of threads may use one at once. The stage and the plan that made it
/// outlive it. Only this class and its plan know their method.
class Warper {
 public:
  virtual ~Warper() = default;
  Warper(const Warper&) = delete;
  Warper& operator=(const Warper&) = delete;

  /// What the frame takes of each picture's colour.
  const std::vector<WeightRange>& weights() const noexcept { return weights_; }

  /// Positions in every picture for the canvas rows from `top` on, all sides in one pass.
  /// @param maps     one per side, as wide as the canvas, of equal heights; written through. NaN: nothing there.
  /// @param weights  what every pixel takes of each picture but the first, which has the rest; of the same size; empty
  ///                 if not wanted.
  virtual void positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const = 0;

  /// Positions in one picture for the whole canvas; parallel over bands.
  virtual warp::Map map(SideIndex side, Pixels pixels) const;

  /// The picture of a side warped as a whole, for methods that do not sample it at positions; else nothing.
  virtual std::optional<warp::Image> drawn(SideIndex) const { return std::nullopt; }

  /// What every pixel of a canvas row takes of a picture, for methods that draw whole pictures. @pre side > 0.
  virtual void weight_row(SideIndex, int, std::span<float>) const {}

  /// What is wrong with this moment. @pre the stage shows the whole canvas. Cost: a map of each side that shows, unless
  /// the method cannot fold; by lines also lines^2, by a mesh O(vertices).
  virtual std::vector<Finding> problems() const = 0;

  /// Where a point of one picture lies in another one, px of the image files: by what corresponds, whatever the
  /// weights. Nothing if that says nothing there. The stage needs no images. @pre the point is finite.
  /// Cost: O(lines) or O(vertices).
  virtual std::optional<cv::Point2d> carry(SideIndex from, SideIndex to, cv::Point2d point) const = 0;

  /// What does the work, in a few words for --verbose.
  virtual std::string label() const = 0;

 protected:
  /// @param weights  of the moment, over everything that the frame is made of.
  Warper(project::Moment moment, const Stage& stage, std::vector<WeightRange> weights)
      : moment_(std::move(moment)), stage_(stage), weights_(std::move(weights)) {}

  const project::Moment& moment() const noexcept { return moment_; }
  const Stage& stage() const noexcept { return stage_; }

  /// Where the map of a side that shows turns over, one finding per side.
  std::vector<Finding> map_folds() const;

 private:
  /// Puts what is nearest to a fold into the finding, and names it: "the vertex in column 2, row 3"; "" if nothing is.
  virtual std::string name_nearest(Finding& fold) const = 0;

  const project::Moment moment_;
  const Stage& stage_;
  std::vector<WeightRange> weights_;
};

/// The progress at which the picture `side` is whole, in [0, 1].
double end_of(SideIndex side, std::size_t sides);

/// What a method knows of a whole shot. Immutable. The evaluator and the stage outlive it.
class Plan {
 public:
  virtual ~Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  virtual std::unique_ptr<Warper> at(const project::Moment& moment) const = 0;

  /// As Warper::weights, without a warper. Cost: O(features) or O(vertices).
  virtual std::vector<WeightRange> weights(const project::Moment& moment) const = 0;

  /// @throws Error kBadInput if the moment cannot be rendered, naming what is in the way.
  virtual void require(const project::Moment&) const {}

  /// Memory that a frame takes beside its result and a few rows for every thread.
  virtual std::size_t scratch_bytes() const { return 0; }

 protected:
  Plan() = default;
};

/// The plan of the project's method.
/// @param moments      of the project. @param allow_folds  render meshes that fold as far as that goes.
/// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds and must not.
std::unique_ptr<Plan> make_plan(const project::Project& project, const project::Evaluator& moments, const Stage& stage,
                                bool allow_folds);

}  // namespace morphkit::render
