#pragma once
// The pictures that a project names, from their files.

#include <optional>
#include <string>
#include <vector>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/footage.h"

namespace morphkit::job {

struct Pictures {
  std::vector<media::Picture> sides;  ///< in the order of Project::pictures
  std::optional<media::Picture> background;
  std::string digest;  ///< of the bytes of all the files
};

/// Loads what the project names, several files at once. @throws Error as media::read_picture, of the first bad picture.
Pictures load_pictures(const project::Project& project);

/// The pictures for a render::Renderer; their pixels are shared.
render::Footage footage_of(const Pictures& pictures);

}  // namespace morphkit::job
