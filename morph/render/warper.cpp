#include "morph/render/warper.h"

#include <variant>
#include <vector>

#include "base/parallel.h"
#include "morph/render/line_warper.h"
#include "morph/render/mesh_warper.h"
#include "warp/field/line_field.h"

namespace morphkit::render {
namespace {

struct MakePlan {
  const project::Project& project;
  const Stage& stage;
  bool allow_folds;

  std::unique_ptr<Plan> operator()(const project::LinesMethod& method) const {
    return std::make_unique<LinePlan>(project, method, stage);
  }
  std::unique_ptr<Plan> operator()(const project::MeshMethod& method) const {
    return std::make_unique<MeshPlan>(project, method, stage, allow_folds);
  }
};

}  // namespace

warp::Map Warper::map(SideIndex side, Pixels pixels) const {
  warp::Map map(stage_.size);
  for_rows(
      map.rows,
      [&](int begin, int end) {
        std::vector<warp::Map> maps;
        for (SideIndex i = 0; i < stage_.sides.size(); ++i)
          maps.push_back(i == side ? warp::Map(map.rowRange(begin, end)) : warp::Map(end - begin, map.cols));
        positions(begin, maps, pixels, nullptr);
      },
      warp::kFieldTile);
  return map;
}

std::unique_ptr<Plan> make_plan(const project::Project& project, const Stage& stage, bool allow_folds) {
  return std::visit(MakePlan{project, stage, allow_folds}, project::method_of(project));
}

}  // namespace morphkit::render
