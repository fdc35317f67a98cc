#pragma once
// The .mesh files of xmorph and gtkmorph. Internal to morph/exchange.

#include <span>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/exchange/import.h"
#include "warp/mesh/mesh.h"

namespace morphkit::exchange {

std::vector<std::string> import_xmorph(project::Project& project, const ImportInput& input);
std::vector<std::string> export_xmorph(const project::Project& project, const ExportOutput& output);

/// Lays the meshes of all pictures over the project, without folds. @return remarks. @throws Error as import_into.
std::vector<std::string> import_meshes(project::Project& project, std::span<const MeshFile> files);

/// @param text     contents of the file. @param name  for messages.
/// @param size     of the picture to which the mesh is scaled, px.
/// @param remarks  receives the assumptions.
/// @throws Error kBadInput "name:line: ...". Memory: by the real contents, not by the counts in the header.
warp::Mesh parse_xmorph_mesh(const std::string& text, const std::string& name, cv::Size size,
                             std::vector<std::string>& remarks);

/// The inverse. @pre size is at least 2 x 2.
std::string xmorph_mesh_text(const warp::Mesh& mesh, cv::Size size);

}  // namespace morphkit::exchange
