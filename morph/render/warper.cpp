#include "morph/render/warper.h"

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/parallel.h"
#include "morph/render/line_warper.h"
#include "morph/render/mesh_warper.h"
#include "warp/analysis.h"
#include "warp/field/line_field.h"

namespace morphkit::render {
namespace {

struct MakePlan {
  const project::Project& project;
  const project::Evaluator& moments;
  const Stage& stage;
  bool allow_folds;

  std::unique_ptr<Plan> operator()(const project::LinesMethod&) const {
    return std::make_unique<LinePlan>(moments, stage);
  }
  std::unique_ptr<Plan> operator()(const project::MeshMethod&) const {
    return std::make_unique<MeshPlan>(project, moments, stage, allow_folds);
  }
};

}  // namespace

std::vector<WeightRange> ranges_of(std::span<const project::Weights> weights) {
  std::vector<WeightRange> ranges(weights.front().dissolve.size(), {1, 0});
  for (const project::Weights& one : weights)
    for (SideIndex side = 0; side < ranges.size(); ++side) {
      ranges[side].least = std::min(ranges[side].least, one.dissolve[side]);
      ranges[side].most = std::max(ranges[side].most, one.dissolve[side]);
    }
  return ranges;
}

warp::Map Warper::map(SideIndex side, Pixels pixels) const {
  warp::Map map(stage_.size);
  for_rows(
      map.rows,
      [&](int begin, int end) {
        std::vector<warp::Map> maps;
        for (SideIndex i = 0; i < stage_.sides.size(); ++i)
          maps.push_back(i == side ? warp::Map(map.rowRange(begin, end)) : warp::Map(end - begin, map.cols));
        positions(begin, maps, pixels, {});
      },
      warp::kFieldTile);
  return map;
}

std::vector<Finding> Warper::map_folds() const {
  std::vector<Finding> findings;
  for (SideIndex side = 0; side < weights_.size(); ++side) {
    if (!weights_[side].shows()) continue;
    const std::vector<warp::FoldRegion> regions = warp::find_folds(map(side, Pixels::kFile));
    if (regions.empty()) continue;
    Finding fold;
    fold.kind = Finding::Kind::kFold;
    fold.where = name_of(side);
    fold.t = moment_.time.t;
    fold.count = static_cast<int>(regions.size());
    fold.position = regions.front().centroid;
    for (const warp::FoldRegion& region : regions) fold.area_px += region.area_px;
    fold.message = fmt::format("the {} folds over in {} {} ({} px at t = {:g}), the largest at ({:.0f}, {:.0f})",
                               fold.where, fold.count, fold.count == 1 ? "place" : "places", fold.area_px, fold.t,
                               fold.position.x, fold.position.y);
    if (const std::string nearest = name_nearest(fold); !nearest.empty()) fold.message += " near " + nearest;
    findings.push_back(std::move(fold));
  }
  return findings;
}

double end_of(SideIndex side, std::size_t sides) {
  return sides > 1 ? static_cast<double>(side) / static_cast<double>(sides - 1) : 0;
}

std::unique_ptr<Plan> make_plan(const project::Project& project, const project::Evaluator& moments, const Stage& stage,
                                bool allow_folds) {
  return std::visit(MakePlan{project, moments, stage, allow_folds}, project::method_of(project));
}

}  // namespace morphkit::render
