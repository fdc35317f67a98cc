#include "morph/render/morpher.h"

#include "morph/render/line_morpher.h"
#include "morph/render/mesh_morpher.h"

namespace morphkit::render {

std::unique_ptr<Morpher> make_morpher(const project::Project& project, const Stage& stage, bool allow_folds) {
  if (project::method_name_of(project) == project::MethodName::kMesh)
    return std::make_unique<MeshMorpher>(project, stage, allow_folds);
  return std::make_unique<LineMorpher>(project, stage);
}

}  // namespace morphkit::render
