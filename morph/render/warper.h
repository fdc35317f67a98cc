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

/// The values of t at which a morph is checked before it is rendered.
inline constexpr double kMoments[] = {0, 0.25, 0.5, 0.75, 1};

/// Which pixels of a picture positions are measured in.
enum class Pixels {
  kHeld,  ///< of the picture as the stage holds it: what is sampled
  kFile   ///< of the image file
};

/// The range of one picture's dissolve weight over all pixels of a frame, in [0, 1].
struct WeightRange {
  double least = 0, most = 0;

  bool is_local() const noexcept { return least != most; }
  bool shows() const noexcept { return most > 0; }
};

/// One range per picture, over all these weights. @pre not empty.
std::vector<WeightRange> ranges_of(std::span<const project::Weights> weights);

/// The warp of one moment. Immutable: any number of threads may use one at once. The stage and the plan that made it
/// outlive it. Only this class and its plan know their method.
class Warper {
 public:
  virtual ~Warper() = default;
  Warper(const Warper&) = delete;
  Warper& operator=(const Warper&) = delete;

  /// The range of each picture's dissolve weight.
  const std::vector<WeightRange>& weights() const noexcept { return weights_; }

  /// Positions in every picture for the canvas rows from `top` on, all sides in one pass.
  /// @param maps     one per side, as wide as the canvas, of equal heights; written through. NaN: nothing there.
  /// @param weights  the dissolve weight of each picture but the first, per pixel, of the size of the maps; the first
  ///                 picture has the rest. Empty: not wanted.
  virtual void positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const = 0;

  /// Positions in one picture for the whole canvas; parallel over bands.
  virtual warp::Map map(SideIndex side, Pixels pixels) const;

  /// The warped picture of a side, from methods that do not sample at positions; else nothing.
  virtual std::optional<warp::Image> drawn(SideIndex) const { return std::nullopt; }

  /// The dissolve weight of a picture along a canvas row, from methods that draw whole pictures. @pre side > 0.
  virtual void weight_row(SideIndex, int, std::span<float>) const {}

  /// The problems of this moment. @pre the stage shows the whole canvas. Cost: a map of each side that shows, unless
  /// the method cannot fold; by lines also lines^2, by a mesh O(vertices).
  virtual std::vector<Finding> problems() const = 0;

  /// The point of one picture that corresponds to a point of another, px of the image files, whatever the weights.
  /// Nothing if there is none. The stage needs no images. @pre the point is finite.
  /// Cost: O(lines) or O(vertices).
  virtual std::optional<cv::Point2d> carry(SideIndex from, SideIndex to, cv::Point2d point) const = 0;

  /// A few words that describe the method, for logs.
  virtual std::string label() const = 0;

 protected:
  /// @param weights  of the moment, over the whole frame.
  Warper(project::Moment moment, const Stage& stage, std::vector<WeightRange> weights)
      : moment_(std::move(moment)), stage_(stage), weights_(std::move(weights)) {}

  const project::Moment& moment() const noexcept { return moment_; }
  const Stage& stage() const noexcept { return stage_; }

  /// Folds of the maps of the sides that show, one finding per side.
  std::vector<Finding> map_folds() const;

 private:
  /// Adds the marks nearest to a fold to the finding. @return their name: "the vertex in column 2, row 3"; "" if there
  /// is none.
  virtual std::string name_nearest(Finding& fold) const = 0;

  const project::Moment moment_;
  const Stage& stage_;
  std::vector<WeightRange> weights_;
};

/// The progress at which the picture `side` is whole, in [0, 1].
double end_of(SideIndex side, std::size_t sides);

/// What a method prepares for a whole shot. Immutable. The evaluator and the stage outlive it.
class Plan {
 public:
  virtual ~Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  virtual std::unique_ptr<Warper> at(const project::Moment& moment) const = 0;

  /// As Warper::weights, without a warper. Cost: O(features) or O(vertices).
  virtual std::vector<WeightRange> weights(const project::Moment& moment) const = 0;

  /// @throws Error kBadInput if the moment cannot be rendered, naming the obstacle.
  virtual void require(const project::Moment&) const {}

  /// Memory of a frame, apart from its result and a few rows per thread.
  virtual std::size_t scratch_bytes() const { return 0; }

 protected:
  Plan() = default;
};

/// The plan of the project's method.
/// @param moments      of the project. @param allow_folds  render meshes that fold as far as possible.
/// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds without allow_folds.
std::unique_ptr<Plan> make_plan(const project::Project& project, const project::Evaluator& moments, const Stage& stage,
                                bool allow_folds);

}  // namespace morphkit::render
