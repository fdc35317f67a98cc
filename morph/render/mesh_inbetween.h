#pragma once
// The mesh of both sides -> the mesh of one moment.

#include <vector>

#include "morph/project/project.h"
#include "morph/render/stage.h"
#include "warp/mesh/mesh.h"

namespace morphkit::render {

/// The project's mesh on both pictures, border vertices exactly on the borders, with the timings of its vertices.
struct MeshPair {
  warp::Mesh source_file, destination_file;      ///< px of the image files
  warp::Mesh source_held, destination_held;      ///< px of the pictures as the stage holds them
  warp::Mesh source_canvas, destination_canvas;  ///< canvas px
  std::vector<project::Pace> timings;            ///< of the project, then of groups; no member empty
  std::vector<std::size_t> timing;               ///< per vertex: index into timings

  const warp::Mesh& file(SideIndex side) const { return side == kSource ? source_file : destination_file; }
  const warp::Mesh& held(SideIndex side) const { return side == kSource ? source_held : destination_held; }
};

/// Allowed distance of a border vertex from its border, px: rounding in files of other tools.
inline constexpr double kOutlineTolerancePx = 0.5;

/// The project's mesh on one side's picture, px of it; border vertices exactly on the border.
/// @param picture  size of that picture, px.
/// @pre the project has a mesh.
/// @throws Error kBadInput naming the vertex if a border vertex is not on its border.
warp::Mesh mesh_on(const project::Project& project, SideIndex side, cv::Size picture);

/// A mesh over a picture, scaled to another size; border vertices exactly on the border. With equal sizes it stays the
/// same to the bit.
warp::Mesh brought_to(warp::Mesh mesh, cv::Size from, cv::Size to);

/// @pre the project has a mesh. @throws Error as mesh_on.
MeshPair mesh_pair(const project::Project& project, const Stage& stage);

/// The in-between mesh of the moment t in [0, 1], canvas px: every vertex moves straight, with the timing of its group.
/// The outline moves with the timing of the project.
warp::Mesh between(const MeshPair& pair, double t);

/// The dissolve progress of every vertex at t, in [0, 1].
std::vector<double> dissolves(const MeshPair& pair, double t);

/// Whether any part of that side's picture is visible in the frame at t.
bool shows(const MeshPair& pair, SideIndex side, double t);

}  // namespace morphkit::render
