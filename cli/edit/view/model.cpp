#include "cli/edit/view/model.h"

#include "morph/render/stage.h"

namespace morphkit::edit {

cv::Size Model::content_size(Pane pane) const {
  if (pane == Pane::kResult) return render::canvas_size(document.project(), document.picture_size(project::kSource));
  return document.picture_size(pane == Pane::kSource ? project::kSource : project::kDestination);
}

void Model::fit_views() {
  const Panes panes = panes_of(canvas_size);
  for (const Pane pane : kPanes) view(pane) = fitted(content_size(pane), panes.pane(pane).size());
}

}  // namespace morphkit::edit
