#pragma once
// The .mesh files of xmorph and gtkmorph. Internal to morph/project.

#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/exchange/import.h"
#include "warp/mesh/mesh.h"

namespace morphkit::exchange {

std::vector<std::string> import_xmorph(project::Project& project, const ImportInput& input);
std::vector<std::string> export_xmorph(const project::Project& project, const ExportOutput& output);

/// @param text     contents of the file. @param name  for messages.
/// @param size     of the picture that the mesh is brought to, px.
/// @param remarks  what was assumed is added.
/// @throws Error kBadInput "name:line: ...". Memory: what the text holds, not what it promises.
warp::Mesh parse_xmorph_mesh(const std::string& text, const std::string& name, cv::Size size,
                             std::vector<std::string>& remarks);

/// The other way. @pre size is at least 2 x 2.
std::string xmorph_mesh_text(const warp::Mesh& mesh, cv::Size size);

}  // namespace morphkit::exchange
