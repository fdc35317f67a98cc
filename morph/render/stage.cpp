#include "morph/render/stage.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

#include <opencv2/imgproc.hpp>

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

}  // namespace

const char* name_of(SideIndex side) {
  return side == kSource ? "source" : "destination";
}

void bring_to_held(const StageSide& side, warp::Map& positions) {
  const cv::Size held = side.image.size();
  if (held == side.file_size) return;
  const auto x = static_cast<float>(static_cast<double>(held.width) / side.file_size.width);
  const auto y = static_cast<float>(static_cast<double>(held.height) / side.file_size.height);
  for (warp::MapPoint& position : positions) position = {position[0] * x, position[1] * y};
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
  return {size, 1, make_side(project, unscaled(pictures.source), size, {size, 1, {}}, kAnyArea),
          make_side(project, unscaled(pictures.destination), size, {size, 1, {}}, kAnyArea)};
}

Stage make_stage(const project::Project& project, const ScaledPicture& source, const ScaledPicture& destination,
                 const CanvasView& view) {
  const cv::Size canvas = canvas_size(project, source.size);
  return {view.size, 1 / view.zoom, make_side(project, source, canvas, view, kReducedAreaPx),
          make_side(project, destination, canvas, view, kReducedAreaPx)};
}

}  // namespace morphkit::render
