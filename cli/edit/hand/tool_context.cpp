#include "cli/edit/hand/tool_context.h"

#include <cmath>
#include <utility>

#include "cli/edit/hand/snap.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

double length(cv::Point2d d) {
  return std::hypot(d.x, d.y);
}

ToolContext::ToolContext(Model& model, EdgeFinder edges) : model_(model), edges_(std::move(edges)) {}

void ToolContext::select(Selection selection) const {
  model_.held.reset();
  model_.document.select(std::move(selection));
}

cv::Point2d ToolContext::content_at(Pane pane, cv::Point position) const {
  return to_content(model_, panes(), pane, position);
}

cv::Point2d ToolContext::snapped(SideIndex side, cv::Point2d position, const Mouse& mouse, int except) const {
  model_.snapped.reset();
  const Pane pane = pane_of(side);
  const double zoom = model_.view(pane).zoom;
  if (!model_.switches.snap || mouse.alt) return rounded(position, zoom);
  model_.snapped = nearest_end(model_.document, side, position, reach(pane, kEndReach), except);
  if (model_.snapped) return *model_.snapped;  // to the bit: ends that meet stay together
  model_.snapped = edges_(side, position, reach(pane, kEdgeReach), zoom);
  return rounded(model_.snapped.value_or(position), zoom);
}

SideIndex ToolContext::active_side() const {
  const std::optional<Pane> pane = panes().pane_at(model_.mouse);
  if (pane && *pane != Pane::kResult) return side_of(*pane);
  return model_.held ? model_.held->side : pressed_side_;
}

}  // namespace morphkit::edit
