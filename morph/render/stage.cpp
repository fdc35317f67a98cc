#include "morph/render/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <opencv2/imgproc.hpp>

#include "warp/image/color.h"

namespace morphkit::render {
namespace {

/// Where a picture lies in a view of the canvas.
Placement seen(const Placement& on_canvas, const CanvasView& view) {
  return {on_canvas.scale * view.zoom, (on_canvas.offset - view.origin) * view.zoom};
}

/// Holds the picture at the size at which it is shown, if that is smaller.
void hold(StageSide& side, const warp::Image& image, int most_area) {
  const cv::Point2d scale = side.file.scale;
  const cv::Size shown(std::max(1, static_cast<int>(std::lround(side.file_size.width * std::min(1.0, scale.x)))),
                       std::max(1, static_cast<int>(std::lround(side.file_size.height * std::min(1.0, scale.y)))));
  side.image = image;
  if (shown != image.size() && shown.area() <= most_area) {
    warp::Image reduced;
    cv::resize(image, reduced, shown, 0, 0, cv::INTER_AREA);
    side.image = reduced;
  }
  side.held = side.file;
  if (side.image.size() == side.file_size) return;
  side.held.scale = {scale.x * side.file_size.width / side.image.cols,
                     scale.y * side.file_size.height / side.image.rows};
}

StageSide make_side(const project::Project& project, const FootagePicture& picture, cv::Size canvas,
                    const CanvasView& view, int most_area) {
  StageSide side;
  side.file_size = picture.size;
  const Placement on_canvas = place(picture.size, canvas, project.output.fit);
  side.file = seen(on_canvas, view);
  side.border = project.warp.border.value_or(covers(on_canvas, picture.size, canvas) ? warp::Border::kClamp
                                                                                     : warp::Border::kTransparent);
  hold(side, picture.at(std::max(side.file.scale.x, side.file.scale.y)), most_area);
  return side;
}

warp::Pixel premultiplied(const project::Color& color) {
  const auto alpha = static_cast<float>(color.a);
  return {warp::linear_from_srgb(static_cast<float>(color.r)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.g)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.b)) * alpha, alpha};
}

/// The background of a view of the canvas, as Stage::behind.
warp::Image background_of(const project::Project& project, const std::optional<FootagePicture>& picture,
                          cv::Size canvas, const CanvasView& view) {
  if (const auto* color = std::get_if<project::Color>(&project.output.background))
    return color->a > 0 ? warp::Image(1, 1, premultiplied(*color)) : warp::Image();
  if (!picture) return {};
  const Placement placement = seen(place(picture->size, canvas, project::Fit::kCover), view);
  const warp::Image image = picture->at(std::max(placement.scale.x, placement.scale.y));
  const cv::Point2d held(static_cast<double>(image.cols) / picture->size.width,
                         static_cast<double>(image.rows) / picture->size.height);
  warp::Map map(view.size);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const cv::Point2d position = placement.to_image({x + 0.5, y + 0.5});
      map(y, x) = {static_cast<float>(position.x * held.x), static_cast<float>(position.y * held.y)};
    }
  return warp::sample(image, map, {warp::Filter::kArea, warp::Border::kClamp});
}

}  // namespace

const char* name_of(SideIndex side) {
  return side == kSource ? "source" : "destination";
}

cv::Size canvas_size(const project::Project& project, cv::Size first_picture) {
  return project.output.size.value_or(first_picture);
}

Stage make_stage(const project::Project& project, const Footage& footage, const std::optional<CanvasView>& view) {
  if (footage.pictures.size() != project.pictures.size())
    throw std::invalid_argument("make_stage: " + std::to_string(footage.pictures.size()) +
                                " pictures for a project of " + std::to_string(project.pictures.size()));
  const cv::Size canvas = canvas_size(project, footage.pictures.front().size);
  const CanvasView seen_part = view.value_or(CanvasView{canvas, 1, {}});
  const int most_area = view ? kReducedAreaPx : std::numeric_limits<int>::max();
  Stage stage{seen_part.size, 1 / seen_part.zoom, {}, {}};
  for (const FootagePicture& picture : footage.pictures)
    stage.sides.push_back(make_side(project, picture, canvas, seen_part, most_area));
  stage.behind = background_of(project, footage.background, canvas, seen_part);
  return stage;
}

}  // namespace morphkit::render
