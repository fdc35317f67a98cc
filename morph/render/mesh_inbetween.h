#pragma once
// The mesh on every picture -> the mesh of one moment.

#include <filesystem>
#include <vector>

#include "morph/project/evaluate.h"
#include "morph/render/stage.h"
#include "warp/mesh/mesh.h"

namespace morphkit::render {

/// The mesh on one picture, border vertices exactly on the borders.
struct MeshSide {
  warp::Mesh file;    ///< px of the image file
  warp::Mesh held;    ///< px of the picture as the stage holds it
  warp::Mesh canvas;  ///< canvas px
};

/// Allowed distance of a border vertex from its border, px: rounding in files of other tools.
inline constexpr double kOutlineTolerancePx = 0.5;

/// The mesh on one side's picture, px of it; border vertices exactly on the border.
/// @param picture  size of that picture, px. @param project_file  for the message.
/// @throws Error kBadInput naming the vertex if a border vertex is not on its border.
warp::Mesh mesh_on(const project::MomentMesh& mesh, SideIndex side, cv::Size picture,
                   const std::filesystem::path& project_file);

/// A mesh over a picture, scaled to another size; border vertices exactly on the border. With equal sizes it stays the
/// same to the bit.
warp::Mesh scaled_to(warp::Mesh mesh, cv::Size from, cv::Size to);

/// In the order of the pictures. @throws Error as mesh_on.
std::vector<MeshSide> mesh_sides(const project::MomentMesh& mesh, const Stage& stage,
                                 const std::filesystem::path& project_file);

/// The in-between mesh of a moment, canvas px: every vertex moves straight, with the timing of its group. The outline
/// moves with the timing of the project.
/// @param sides  of the moment's mesh. @pre the moment has a mesh.
warp::Mesh between(const std::vector<MeshSide>& sides, const project::Moment& moment);

/// What every vertex takes of one picture's colour, in [0, 1]. @pre the moment has a mesh.
std::vector<double> dissolves(const project::Moment& moment, SideIndex side);

}  // namespace morphkit::render
