#pragma once
// Morphing by a mesh: each picture is warped in two passes onto the in-between mesh, then both are mixed.

#include "morph/render/mesh_inbetween.h"
#include "morph/render/morpher.h"
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

/// For all frames at once, since a change on the way would show as a jump: the order that `project` asks for, or of
/// both the one with fewer folds, then with less area lost.
MeshPasses choose_passes(const project::Project& project, const MeshPair& pair, SideIndex side);

class MeshMorpher : public Morpher {
 public:
  /// @throws Error kBadInput if the mesh does not fit the pictures, or folds and allow_folds is false.
  MeshMorpher(const project::Project& project, const Stage& stage, bool allow_folds);

  void require(double t) const override;
  warp::Image frame(double t) const override;
  bool shows(SideIndex side, double t) const override { return render::shows(pair_, side, t); }
  warp::Map map(double t, SideIndex side) const override;
  std::size_t scratch_bytes() const override;
  std::string description() const override;

 private:
  warp::PassOrder order(SideIndex side) const { return (side == kSource ? source_passes_ : destination_passes_).order; }
  warp::Image warped(SideIndex side, const warp::Mesh& to) const;
  void mix(warp::Image& source, const warp::Image& destination, const warp::Mesh& mesh,
           std::span<const double> dissolve) const;

  const project::Project& project_;
  const Stage& stage_;
  MeshPair pair_;
  MeshPasses source_passes_, destination_passes_;
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
