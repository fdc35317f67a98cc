#include "cli/edit/view/canvas.h"

#include <algorithm>
#include <string>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "cli/edit/view/draw_chrome.h"
#include "cli/edit/view/draw_marks.h"
#include "cli/edit/view/draw_overlays.h"
#include "cli/edit/view/layout.h"
#include "cli/edit/view/paint.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

/// From here on pixels are shown as squares.
constexpr double kSquaresAbove = 6;

cv::Mat3b seen(const Pyramid& pyramid, const View& view, cv::Size pane) {
  const cv::Mat3b& level = pyramid.display(view.zoom);
  const double across = static_cast<double>(level.cols) / pyramid.size().width;
  const double down = static_cast<double>(level.rows) / pyramid.size().height;
  const cv::Point2d corner = view.to_picture({0.5, 0.5}, pane);
  const cv::Matx23d map(across / view.zoom, 0, corner.x * across - 0.5, 0, down / view.zoom, corner.y * down - 0.5);
  return placed(level, map, pane, view.zoom > kSquaresAbove ? cv::INTER_NEAREST : cv::INTER_LINEAR);
}

/// Words broken into lines that fit.
std::vector<std::string> wrapped(const std::string& text, const Type& type, int height, int width) {
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || type.width(longer, height) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
    begin = end + 1;
  }
  return lines;
}

}  // namespace

const cv::Mat3b& Canvas::draw(const Model& model, const PreviewPicture& preview) {
  const Layout layout = layout_beneath(model);
  canvas_.create(model.canvas_size);
  fill(canvas_, {{0, 0}, canvas_.size()}, palette::kBackground);
  draw_picture(model, layout, project::kSource);
  draw_picture(model, layout, project::kDestination);
  draw_result(model, layout, preview);
  draw_chrome(canvas_, model, layout, preview, type_);
  if (model.switches.loupe && !model.help && !model.question) draw_loupe(canvas_, model, layout, source_, destination_);
  if (model.welcome && !model.question) draw_welcome(canvas_, layout, type_);
  if (model.help && !model.question) draw_help(canvas_, layout, type_);
  if (model.question) draw_question(canvas_, model, layout_of(model), type_);
  return canvas_;
}

void Canvas::draw_picture(const Model& model, const Panes& panes, SideIndex side) {
  const Pane pane = pane_of(side);
  const cv::Rect& rect = panes.pane(pane);
  std::optional<Shown>& shown = shown_[static_cast<int>(pane)];
  const View& view = model.view(pane);
  if (!shown || shown->view != view || shown->pixels.size() != rect.size())
    shown = Shown{view, seen(side == project::kSource ? source_ : destination_, view, rect.size())};
  cv::Mat3b target = canvas_(rect);
  shown->pixels.copyTo(target);
  draw_marks(target, model, side, panes.scale, type_);
}

void Canvas::draw_result(const Model& model, const Panes& panes, const PreviewPicture& preview) {
  cv::Mat3b target = canvas_(panes.pane(Pane::kResult));
  if (!preview.problem.empty()) {
    const int height = static_cast<int>(14 * panes.scale);
    int y = target.rows / 3;
    for (const std::string& line : wrapped(preview.problem, type_, height, target.cols - 4 * height))
      type_.draw(target, line, {2 * height, y += 2 * height}, height, palette::kText);
    return;
  }
  const cv::Rect area = preview.area & cv::Rect({0, 0}, target.size());
  if (preview.image.empty() || area.empty() || area != preview.area) return;  // or of a pane that had another size
  cv::resize(preview.image, target(area), area.size(), 0, 0, cv::INTER_LINEAR);
  const bool lines = model.document.method() == project::MethodName::kLines;
  if (model.switches.features && lines)
    draw_between(
        target, model, [&](const project::Moment& moment) -> auto& { return lines_of(model, moment); }, panes.scale);
}

const std::vector<render::FeatureLine>& Canvas::lines_of(const Model& model, const project::Moment& moment) {
  if (features_ != moment.features) {
    const cv::Size canvas = model.content_size(Pane::kResult);
    const project::Fit fit = model.document.project().output.fit;
    std::vector<render::Placement> placements;
    for (SideIndex side = 0; side < model.document.project().pictures.size(); ++side)
      placements.push_back(render::place(model.document.picture_size(side), canvas, fit));
    lines_ = render::feature_lines(*moment.features, placements);
    features_ = moment.features;
  }
  return lines_;
}

}  // namespace morphkit::edit
