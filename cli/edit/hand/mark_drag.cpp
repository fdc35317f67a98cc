#include "cli/edit/hand/mark_drag.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/edit/hand/snap.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

/// The selection with `item` added, or removed if it was in.
std::vector<int> toggled(std::vector<int> selected, int item) {
  const auto found = std::ranges::lower_bound(selected, item);
  if (found != selected.end() && *found == item) {
    selected.erase(found);
  } else {
    selected.insert(found, item);
  }
  return selected;
}

bool is_vertex(const Handle& handle) {
  return handle.vertex >= 0;
}

Selection only(const Handle& handle) {
  return is_vertex(handle) ? Selection{{}, {handle.vertex}} : Selection{{handle.feature}, {}};
}

void begin_step(Document& document) {
  if (!document.in_step()) document.begin();
}

/// Ends the step. A click on one of several selected marks selects it alone.
void end_drag(const ToolContext& context, const Handle& handle, bool moved) {
  Document& document = context.document();
  if (document.in_step()) document.end();
  if (moved) return;
  const Selection& selection = document.selection();
  if ((is_vertex(handle) ? selection.vertices : selection.features).size() < 2) return;
  context.select(only(handle));
  context.model().held = handle;
}

}  // namespace

std::unique_ptr<Drag> press_mark(ToolContext& context, const Press& press, const Handle& handle) {
  Document& document = context.document();
  Selection selection = document.selection();
  std::vector<int>& items = is_vertex(handle) ? selection.vertices : selection.features;
  const int item = is_vertex(handle) ? handle.vertex : handle.feature;
  if (press.mouse.shift || press.mouse.ctrl) {
    items = toggled(std::move(items), item);
    context.select(std::move(selection));
    return nullptr;
  }
  if (!std::ranges::binary_search(items, item)) context.select(only(handle));
  context.model().held = handle;
  if (!is_vertex(handle) && handle.point >= 0) return std::make_unique<PointDrag>(context, press, handle);
  return std::make_unique<SelectionDrag>(context, press, handle);
}

PointDrag::PointDrag(ToolContext& context, const Press& press, const Handle& handle)
    : PictureDrag(context, press), handle_(handle), from_(position_of(context.model(), handle)) {
  begin_step(context.document());
}

void PointDrag::follow(const Mouse& mouse, cv::Point2d now) {
  const cv::Point2d by = now - press().content;
  const cv::Point2d to =
      by == cv::Point2d() ? from_ : context().snapped(handle_.side, from_ + by, mouse, handle_.feature);
  context().document().move_point(handle_.feature, handle_.side, handle_.point, to);
}

void PointDrag::release(const Mouse&) {
  end_drag(context(), handle_, moved());
}

SelectionDrag::SelectionDrag(ToolContext& context, const Press& press, const Handle& handle)
    : PictureDrag(context, press), handle_(handle) {
  begin_step(context.document());
}

void SelectionDrag::follow(const Mouse&, cv::Point2d now) {
  Document& document = context().document();
  const cv::Point2d by = rounded(now - press().content, context().model().view(press().pane).zoom);
  // Always from the places at the press: a vertex that a border has held back returns under the mouse.
  document.cancel();
  document.begin();
  if (by == cv::Point2d()) return;
  if (is_vertex(handle_)) {
    document.move_vertices(std::vector<int>(document.selection().vertices), handle_.side, by);
  } else {
    document.move_selected(handle_.side, by);
  }
}

void SelectionDrag::release(const Mouse&) {
  end_drag(context(), handle_, moved());
}

}  // namespace morphkit::edit
