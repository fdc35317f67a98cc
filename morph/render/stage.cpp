#include "morph/render/stage.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace morphkit::render {
namespace {

media::Picture load(const project::Project& project, const project::Side& side) {
  const media::ColorSpace space =
      side.colorspace.empty() ? media::ColorSpace::kAuto : media::color_space_from(side.colorspace);
  return media::read_picture(project::resolve(project, side.image), space);
}

StageSide make_side(const project::Project& project, const media::Picture& picture, cv::Size canvas) {
  StageSide side;
  const cv::Size file_size = picture.image.size();
  side.image = picture.image;
  side.file_size = file_size;
  side.file = place(file_size, canvas, project.output.fit);
  side.held = side.file;
  side.border = project.warp.border.value_or(covers(side.file, file_size, canvas) ? warp::Border::kClamp
                                                                                  : warp::Border::kTransparent);
  const cv::Point2d scale = side.file.scale;
  if (scale.x >= 1 && scale.y >= 1) return side;
  const cv::Size held_size(std::max(1, static_cast<int>(std::lround(file_size.width * std::min(1.0, scale.x)))),
                           std::max(1, static_cast<int>(std::lround(file_size.height * std::min(1.0, scale.y)))));
  warp::Image reduced;
  cv::resize(picture.image, reduced, held_size, 0, 0, cv::INTER_AREA);
  side.image = reduced;
  side.held.scale = {scale.x * file_size.width / held_size.width, scale.y * file_size.height / held_size.height};
  return side;
}

}  // namespace

const char* name_of(SideName side) {
  return side == SideName::kSource ? "source" : "destination";
}

Pictures load_pictures(const project::Project& project) {
  Pictures pictures{load(project, project.source), load(project, project.destination), {}};
  if (const auto* file = std::get_if<std::filesystem::path>(&project.output.background))
    pictures.background = media::read_picture(project::resolve(project, *file));
  return pictures;
}

cv::Size canvas_size(const project::Project& project, cv::Size source_picture) {
  return project.output.size.value_or(source_picture);
}

Stage make_stage(const project::Project& project, const Pictures& pictures) {
  const cv::Size size = canvas_size(project, pictures.source.image.size());
  return {size, make_side(project, pictures.source, size), make_side(project, pictures.destination, size)};
}

}  // namespace morphkit::render
