#include "cli/edit/hand/views.h"

#include <algorithm>
#include <cmath>

namespace morphkit::edit {
namespace {

constexpr double kZoomPerNotch = 1.2;

}  // namespace

void zoom_by_wheel(Model& model, const Mouse& mouse) {
  const Panes panes = panes_of(model.canvas_size);
  const std::optional<Pane> pane = panes.pane_at(mouse.position);
  if (!pane || model.question || model.help) return;
  const cv::Rect& rect = panes.pane(*pane);
  model.view(*pane) =
      zoomed(model.view(*pane), std::pow(kZoomPerNotch, mouse.notches), mouse.position - rect.tl(), rect.size());
  follow_view(model, *pane);
}

void follow_view(Model& model, Pane pane) {
  if (!model.switches.locked || pane == Pane::kResult) return;
  const Pane partner = pane == Pane::kSource ? Pane::kDestination : Pane::kSource;
  model.view(partner) = matching(model.view(pane), model.content_size(pane), model.content_size(partner));
}

void PanDrag::move(const Mouse& mouse) {
  Model& model = context_.model();
  View& view = model.view(pane_);
  view.centre += last_ - context_.content_at(pane_, mouse.position);
  const cv::Size size = model.content_size(pane_);
  view.centre.x = std::clamp(view.centre.x, 0.0, static_cast<double>(size.width));
  view.centre.y = std::clamp(view.centre.y, 0.0, static_cast<double>(size.height));
  last_ = context_.content_at(pane_, mouse.position);
  follow_view(model, pane_);
}

}  // namespace morphkit::edit
