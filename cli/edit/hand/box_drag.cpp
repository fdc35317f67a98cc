#include "cli/edit/hand/box_drag.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

std::vector<int> united(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::sort(a);
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

Selection inside_of(const cv::Rect2d& box, const Model& model, SideIndex side) {
  const auto inside = [&](cv::Point2d at) {
    return at.x >= box.x && at.y >= box.y && at.x <= box.br().x && at.y <= box.br().y;
  };
  Selection found;
  const project::Moment moment = model.moment();
  if (row_of(model.tool).edits == Edits::kMesh) {
    if (!moment.mesh) return found;
    const project::Points vertices = vertices_of(model, moment, side);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (inside(vertices[i])) found.vertices.push_back(static_cast<int>(i));
    return found;
  }
  const std::vector<project::MomentFeature>& features = *moment.features;
  for (std::size_t i = 0; i < features.size(); ++i)
    if (std::ranges::any_of(outline_of(features[i].mark, features[i].places[side]), inside))
      found.features.push_back(static_cast<int>(i));
  return found;
}

}  // namespace

BoxDrag::BoxDrag(ToolContext& context, const Press& press) : PictureDrag(context, press) {
  context.model().sketch = Sketch{Sketch::Shape::kBox, side_of(press.pane), {press.content, press.content}, {}};
}

void BoxDrag::follow(const Mouse&, cv::Point2d now) {
  context().model().sketch->points.back() = now;
}

void BoxDrag::release(const Mouse&) {
  Model& model = context().model();
  const Sketch sketch = *std::exchange(model.sketch, std::nullopt);
  Selection found = inside_of({sketch.points[0], sketch.points[1]}, model, sketch.side);
  if (press().mouse.shift) {
    found.features = united(std::move(found.features), model.document.selection().features);
    found.vertices = united(std::move(found.vertices), model.document.selection().vertices);
  }
  context().select(std::move(found));
}

}  // namespace morphkit::edit
