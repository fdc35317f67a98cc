#include "morph/render/renderer.h"

#include <algorithm>
#include <utility>

#include "morph/render/compose.h"

namespace morphkit::render {

Renderer::Renderer(project::Project project, std::shared_ptr<const Stage> stage, const RendererOptions& options)
    : body_(std::make_unique<const Body>(Body{project::Evaluator(project), std::move(project), std::move(stage)})),
      plan_(make_plan(body_->project, body_->moments, *body_->stage, options.allow_folds)) {}

Renderer::Renderer(const project::Project& project, const Footage& footage, const RendererOptions& options)
    : Renderer(project, std::make_shared<const Stage>(make_stage(project, footage)), options) {
  bool transparent = false;
  for (SideIndex side = 0; side < footage.pictures.size(); ++side)
    transparent |= footage.pictures[side].has_alpha || stage().sides[side].border == warp::Border::kTransparent;
  const warp::Image& behind = stage().behind;
  const bool opaque_behind =
      footage.background ? !footage.background->has_alpha : !behind.empty() && behind(0, 0)[3] >= 1;
  has_alpha_ = !opaque_behind && transparent;
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

std::size_t Renderer::frame_bytes() const {
  return static_cast<std::size_t>(size().area()) * sizeof(warp::Pixel) + plan_->scratch_bytes();
}

warp::Image Renderer::frame(project::Time time) const {
  const project::Moment now = moment(time);
  plan_->require(now);
  warp::Image out = compose(stage(), *plan_->at(now), project().warp.filter, project().blend);
  composite_over(out, stage().behind);
  return out;
}

warp::Image Renderer::side(project::Time time, SideIndex side) const {
  const project::Moment now = moment(time);
  plan_->require(now);
  return draw_side(stage(), *plan_->at(now), side, project().warp.filter);
}

}  // namespace morphkit::render
