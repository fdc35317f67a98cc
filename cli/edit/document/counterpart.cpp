#include "cli/edit/document/counterpart.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>

#include "base/error.h"
#include "cli/edit/document/document.h"
#include "morph/render/warper.h"
#include "warp/mesh/mesh.h"

namespace morphkit::edit {
namespace {

cv::Point2d into(cv::Point2d position, cv::Size picture) {
  return {std::clamp(position.x, 0.0, static_cast<double>(picture.width)),
          std::clamp(position.y, 0.0, static_cast<double>(picture.height))};
}

/// The pictures on the canvas, without their pixels.
render::Stage bare_stage(const project::Project& project, std::span<const cv::Size> sizes) {
  render::Stage stage;
  stage.size = render::canvas_size(project, sizes.front());
  for (const cv::Size& size : sizes) {
    render::StageSide& side = stage.sides.emplace_back();
    side.file_size = size;
    side.file = side.held = render::place(size, stage.size, project.output.fit);
  }
  return stage;
}

/// Carries points by the warp; has nothing to say if the project, as it is being edited, gives none.
class Carrier {
 public:
  Carrier(const project::Project& project, const project::Evaluator& moments, const render::Stage& stage) {
    try {
      plan_ = render::make_plan(project, moments, stage, true);
      warper_ = plan_->at(moments.at(moments.clock().at(0)));
    } catch (const Error&) {  // a mesh that does not fit its pictures
      warper_.reset();
    }
  }

  std::optional<cv::Point2d> carry(SideIndex from, SideIndex to, cv::Point2d position) const {
    return warper_ ? warper_->carry(from, to, position) : std::nullopt;
  }

 private:
  std::unique_ptr<render::Plan> plan_;
  std::unique_ptr<render::Warper> warper_;
};

}  // namespace

project::Points vertices_on(cv::Size picture, int columns, int rows, const project::Points& listed) {
  if (!listed.empty()) return listed;
  return warp::uniform_mesh(columns, rows, {{0, 0}, cv::Size2d(picture)}).vertices;
}

std::vector<cv::Point2d> counterparts(const project::Project& project, const project::Evaluator& moments,
                                      std::span<const cv::Size> sizes, SideIndex side,
                                      std::span<const cv::Point2d> positions) {
  const SideIndex to = other(side);
  const render::Stage stage = bare_stage(project, sizes);
  const Carrier carrier(project, moments, stage);
  std::vector<cv::Point2d> result;
  result.reserve(positions.size());
  for (const cv::Point2d& position : positions) {
    const auto carried = carrier.carry(side, to, position);
    const cv::Point2d below = stage.sides[to].file.to_image(stage.sides[side].file.to_canvas(position));
    result.push_back(into(carried.value_or(below), sizes[to]));
  }
  return result;
}

}  // namespace morphkit::edit
