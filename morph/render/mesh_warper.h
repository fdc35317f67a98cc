#pragma once
// Warping by a mesh: each picture goes in two passes onto the in-between mesh.

#include <string>
#include <vector>

#include "morph/render/mesh_inbetween.h"
#include "morph/render/warper.h"
#include "warp/mesh/mesh_warp.h"

namespace morphkit::render {

/// How one picture goes onto the in-between mesh in one order, at its worst over those of kMoments at which it
/// shows.
struct MeshPasses {
  warp::PassOrder order = warp::PassOrder::kRowsFirst;
  std::size_t folds = 0;  ///< vertices of the intermediate mesh that are out of order
  double area_lost = 0;   ///< see warp::MeshWarp::area_lost
  double t = 0;           ///< when
};

/// Below this, what two passes lose of the area is not seen.
inline constexpr double kVisibleLoss = 0.05;

/// @param order  kRowsFirst or kColumnsFirst.
MeshPasses passes_of(const MeshPair& pair, SideIndex side, warp::PassOrder order);

/// For all frames at once, since a change on the way would show as a jump: the order that is `asked` for, or for
/// kAuto of both the one with fewer folds, then with less area lost.
MeshPasses choose_passes(warp::PassOrder asked, const MeshPair& pair, SideIndex side);

class MeshWarper : public Warper {
 public:
  /// @param pair, passes  of the plan, which outlives this. @param to  the in-between mesh, canvas px.
  /// @param values  the dissolve progress of every vertex. @param border  of both pictures.
  MeshWarper(const MeshPair& pair, std::span<const MeshPasses> passes, warp::MeshSpline spline, warp::Mesh to,
             std::span<const double> values, warp::Border border, const Stage& stage);

  /// Cost: O(columns + rows) for every pixel; `map` is much faster for a whole canvas.
  void positions(int top, std::span<warp::Map> maps, Pixels pixels, cv::Mat1f* dissolve) const override;
  /// What is out of order in the mesh is squashed, as in the frame.
  warp::Map map(SideIndex side, Pixels pixels) const override;
  std::optional<warp::Image> drawn(SideIndex side) const override;
  void dissolve_row(int y, std::span<float> out) const override;

 private:
  warp::MeshWarp bend(SideIndex side, Pixels pixels) const;

  const MeshPair& pair_;
  std::span<const MeshPasses> passes_;
  warp::MeshSpline spline_;
  warp::Mesh to_;
  warp::MeshValues values_;
  warp::Border border_;
};

class MeshPlan : public Plan {
 public:
  /// @throws Error kBadInput if the mesh does not fit the pictures, or folds and allow_folds is false.
  MeshPlan(const project::Project& project, const project::MeshMethod& method, const Stage& stage, bool allow_folds);

  std::unique_ptr<Warper> at(double t) const override;
  DissolveRange dissolve(double t) const override;
  void require(double t) const override;
  std::size_t scratch_bytes() const override;
  std::string label() const override;

 private:
  const project::Project& project_;
  const project::MeshMethod method_;
  const Stage& stage_;
  MeshPair pair_;
  std::vector<MeshPasses> passes_;  ///< per side
  warp::Border border_;
  bool allow_folds_;
};

/// @param what  begins the sentence: "the source mesh folds over". @param place  for the message; if it ends with a
/// slash, the vertex's number is added.
/// @throws Error kBadInput naming the vertex that is out of order most plainly.
void require_unfolded(const warp::Mesh& mesh, const std::string& what, const std::string& place);

/// What is wrong with a vertex, for people: "is not right of its left neighbour".
const char* text_of(warp::MeshFoldKind kind);

/// "rows first" or "columns first".
const char* text_of(warp::PassOrder order);

}  // namespace morphkit::render
