#pragma once
// Warping by a mesh: each picture goes in two passes onto the in-between mesh.

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "morph/render/mesh_inbetween.h"
#include "morph/render/warper.h"
#include "warp/mesh/mesh_warp.h"

namespace morphkit::render {

/// How one picture is warped to the in-between mesh in one order of passes: the worst of kMoments at which it shows.
struct MeshPasses {
  warp::PassOrder order = warp::PassOrder::kRowsFirst;
  std::size_t folds = 0;  ///< vertices of the intermediate mesh that are out of order
  double area_lost = 0;   ///< see warp::MeshWarp::area_lost
  double t = 0;           ///< when
};

/// Below this, the share of the area that two passes lose is not visible.
inline constexpr double kVisibleLoss = 0.05;

/// A moment and its mesh on every picture, shared by moments with an equal mesh.
struct MeshMoment {
  project::Moment moment;
  std::shared_ptr<const std::vector<MeshSide>> sides;
};

/// At one moment. @param held  the mesh on the picture as it is held. @param to  the in-between mesh.
MeshPasses passes_at(const warp::Mesh& held, const warp::Mesh& to, warp::PassOrder order, double t);

/// At the worst of the moments at which the picture shows. @param order  kRowsFirst or kColumnsFirst.
MeshPasses passes_of(std::span<const MeshMoment> moments, SideIndex side, warp::PassOrder order);

/// One order for all frames, because a change between frames would show as a jump: the order `asked` for, or for kAuto
/// the one with fewer folds, then with less area lost.
MeshPasses choose_passes(warp::PassOrder asked, std::span<const MeshMoment> moments, SideIndex side);

class MeshPlan;

class MeshWarper : public Warper {
 public:
  /// @param border  of all pictures.
  MeshWarper(const MeshMoment& mesh, const MeshPlan& plan, warp::Border border, const Stage& stage);

  /// Cost: O(columns + rows) for every pixel; `map` is much faster for a whole canvas.
  void positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const override;
  /// Folded parts of the mesh are squashed, as in the frame.
  warp::Map map(SideIndex side, Pixels pixels) const override;
  std::optional<warp::Image> drawn(SideIndex side) const override;
  void weight_row(SideIndex side, int y, std::span<float> out) const override;
  std::vector<Finding> problems() const override;
  /// By the two triangles of each cell; the curves of a render agree with them at the vertices only, which is good
  /// enough for a first guess. Points beside the picture count as points of its border.
  std::optional<cv::Point2d> carry(SideIndex from, SideIndex to, cv::Point2d point) const override;
  std::string label() const override;

 private:
  std::string name_nearest(Finding& fold) const override;
  warp::MeshWarp bend(SideIndex side, Pixels pixels) const;

  std::shared_ptr<const std::vector<MeshSide>> sides_;
  const MeshPlan& plan_;
  warp::MeshSpline spline_;
  warp::Mesh to_;
  std::vector<warp::MeshValues> values_;  ///< the weights of every side but the first
  warp::Border border_;
};

class MeshPlan : public Plan {
 public:
  /// @throws Error kBadInput if the mesh does not fit the pictures, or folds and allow_folds is false.
  MeshPlan(const project::Project& project, const project::Evaluator& moments, const Stage& stage, bool allow_folds);

  std::unique_ptr<Warper> at(const project::Moment& moment) const override;
  std::vector<WeightRange> weights(const project::Moment& moment) const override;
  void require(const project::Moment& moment) const override;
  std::size_t scratch_bytes() const override;

  /// Per side; chosen when first asked for.
  const std::vector<MeshPasses>& passes() const;

 private:
  MeshMoment mesh_at(const project::Moment& moment) const;

  const std::filesystem::path file_;  ///< the project, for messages
  const project::Evaluator& moments_;
  const Stage& stage_;
  MeshMoment first_;
  warp::Border border_;
  bool allow_folds_;
  mutable std::once_flag chosen_;
  mutable std::vector<MeshPasses> passes_;
};

/// @param what  begins the sentence: "the source mesh folds over". @param place  for the message; if it ends with a
/// slash, the vertex's number is added.
/// @throws Error kBadInput naming the most obvious vertex that is out of order.
void require_unfolded(const warp::Mesh& mesh, const std::string& what, const std::string& place);

/// Describes what is wrong with a vertex: "is not right of its left neighbour".
const char* text_of(warp::MeshFoldKind kind);

/// "rows first" or "columns first".
const char* text_of(warp::PassOrder order);

}  // namespace morphkit::render
