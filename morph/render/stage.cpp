#include "morph/render/stage.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "warp/image/color.h"

namespace morphkit::render {
namespace {

media::Picture load(const project::Project& project, const project::Picture& side) {
  const media::ColorSpace space =
      side.colorspace.empty() ? media::ColorSpace::kAuto : media::color_space_from(side.colorspace);
  return media::read_picture(project::resolve(project, side.image), space);
}

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

StageSide make_side(const project::Project& project, const ScaledPicture& picture, cv::Size canvas,
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

ScaledPicture unscaled(const media::Picture& picture) {
  return {picture.image.size(), [&](double) { return picture.image; }};
}

warp::Pixel premultiplied(const project::Color& color) {
  const auto alpha = static_cast<float>(color.a);
  return {warp::linear_from_srgb(static_cast<float>(color.r)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.g)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.b)) * alpha, alpha};
}

/// What lies behind a view of the canvas, as Stage::behind.
warp::Image background_of(const project::Project& project, const std::optional<ScaledPicture>& picture, cv::Size canvas,
                          const CanvasView& view) {
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

Pictures load_pictures(const project::Project& project) {
  // Reading a picture is the work of one thread; two pictures are that of two.
  auto destination =
      std::async(std::launch::async, [&] { return load(project, project.pictures[project::kDestination]); });
  media::Picture source = load(project, project.pictures[project::kSource]);
  Pictures pictures{std::move(source), destination.get(), {}};
  if (const auto* file = std::get_if<std::filesystem::path>(&project.output.background))
    pictures.background = media::read_picture(project::resolve(project, *file));
  return pictures;
}

cv::Size canvas_size(const project::Project& project, cv::Size source_picture) {
  return project.output.size.value_or(source_picture);
}

Stage make_stage(const project::Project& project, const Pictures& pictures) {
  const cv::Size size = canvas_size(project, pictures.source.image.size());
  constexpr int kAnyArea = std::numeric_limits<int>::max();
  const CanvasView whole{size, 1, {}};
  Stage stage{size, 1, {}, {}};
  for (const auto* picture : {&pictures.source, &pictures.destination})
    stage.sides.push_back(make_side(project, unscaled(*picture), size, whole, kAnyArea));
  stage.behind = background_of(
      project, pictures.background ? std::optional(unscaled(*pictures.background)) : std::nullopt, size, whole);
  return stage;
}

Stage make_stage(const project::Project& project, std::span<const ScaledPicture> pictures,
                 const std::optional<ScaledPicture>& background, const CanvasView& view) {
  const cv::Size canvas = canvas_size(project, pictures.front().size);
  Stage stage{view.size, 1 / view.zoom, {}, {}};
  for (const ScaledPicture& picture : pictures)
    stage.sides.push_back(make_side(project, picture, canvas, view, kReducedAreaPx));
  stage.behind = background_of(project, background, canvas, view);
  return stage;
}

}  // namespace morphkit::render
