#pragma once
// Meshes of other tools as meshes that warp: with their border on that of the picture, and without folds. Internal to
// morph/exchange.

#include <span>
#include <string>
#include <vector>

#include "morph/exchange/import.h"

namespace morphkit::exchange {

/// Border vertices that are farther from the border of the picture than this are no slips, px.
inline constexpr double kBorderSlipPx = 3;

/// Brings the border vertices onto the border of their picture. An edge where all are within kBorderSlipPx of it is
/// moved onto it; else the mesh of every picture gets another row or column there, for the mesh covers only a part.
/// @param remarks  receives what was done, a sentence for each mesh. @pre the meshes have equal numbers of columns and
/// rows.
void fit_to_pictures(std::span<PictureMesh> meshes, std::vector<std::string>& remarks);

/// Moves vertices until none is out of order (warp::find_folds): those that are, towards the middle of their
/// neighbours; if that does not help, all towards an even mesh. A mesh without folds stays as it is.
/// @param remarks  receives how many were moved and how far. @pre the border lies on that of the picture.
void unfold(PictureMesh& mesh, std::vector<std::string>& remarks);

}  // namespace morphkit::exchange
