#include "morph/render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "morph/render/dissolve.h"
#include "warp/color.h"
#include "warp/parallel.h"

namespace morphkit::render {
namespace {

media::Picture load(const project::Project& project, const project::Side& side) {
  const media::ColorSpace space =
      side.colorspace.empty() ? media::ColorSpace::kAuto : media::color_space_from(side.colorspace);
  return media::read_picture(project::resolve(project, side.image), space);
}

void to_image(const Placement& placement, std::span<warp::MapPoint> positions) {
  if (placement.is_identity()) return;
  for (warp::MapPoint& position : positions) {
    const cv::Point2d image = placement.to_image({position[0], position[1]});
    position = {static_cast<float>(image.x), static_cast<float>(image.y)};
  }
}

warp::Pixel premultiplied(const project::Color& color) {
  const auto alpha = static_cast<float>(color.a);
  return {warp::linear_from_srgb(static_cast<float>(color.r)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.g)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.b)) * alpha, alpha};
}

std::span<warp::Pixel> row_of(warp::Image& image, int y) {
  return {image[y], static_cast<std::size_t>(image.cols)};
}

}  // namespace

Pictures load_pictures(const project::Project& project) {
  Pictures pictures{load(project, project.source), load(project, project.destination), {}};
  if (const auto* file = std::get_if<std::filesystem::path>(&project.output.background))
    pictures.background = media::read_picture(project::resolve(project, *file));
  return pictures;
}

cv::Size canvas_size(const project::Project& project, cv::Size source_picture) {
  return project.output.size.value_or(source_picture);
}

/// What all rows of a frame share.
struct Renderer::Moment {
  warp::LineField field;
  float dissolve;
  bool local_dissolve;  ///< false also at the ends, where all features agree
  bool needs_source, needs_destination;
};

Renderer::Renderer(project::Project project, Pictures pictures)
    : project_(std::move(project)), size_(canvas_size(project_, pictures.source.image.size())) {
  source_ = make_side(pictures.source);
  destination_ = make_side(pictures.destination);
  pairs_ = line_pairs(project_, source_.file, destination_.file);
  const motion::Timing whole = *project::effective(project_).dissolve;
  local_dissolve_ = std::any_of(pairs_.begin(), pairs_.end(),
                                [&](const LinePair& pair) { return *pair.influence.dissolve != whole; });
  make_background(pictures.background);
  const auto transparent = [](const media::Picture& picture, const Side& side) {
    return picture.info.has_alpha || picture.nonfinite_pixels > 0 || side.border == warp::Border::kTransparent;
  };
  const bool opaque_behind =
      pictures.background ? !pictures.background->info.has_alpha : !background_.empty() && background_(0, 0)[3] >= 1;
  has_alpha_ =
      !opaque_behind && (transparent(pictures.source, source_) || transparent(pictures.destination, destination_));
}

Renderer::Side Renderer::make_side(const media::Picture& picture) const {
  Side side;
  const cv::Size file_size = picture.image.size();
  side.image = picture.image;
  side.file_size = file_size;
  side.file = place(file_size, size_, project_.output.fit);
  side.held = side.file;
  side.border = project_.warp.border.value_or(covers(side.file, file_size, size_) ? warp::Border::kClamp
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

void Renderer::make_background(const std::optional<media::Picture>& picture) {
  if (!picture) {
    const auto* color = std::get_if<project::Color>(&project_.output.background);
    if (color != nullptr && color->a > 0) background_ = warp::Image(1, 1, premultiplied(*color));
    return;
  }
  const Placement placement = place(picture->image.size(), size_, project::Fit::kCover);
  warp::Map map(size_);
  for (int y = 0; y < size_.height; ++y)
    for (int x = 0; x < size_.width; ++x) {
      const cv::Point2d position = placement.to_image({x + 0.5, y + 0.5});
      map(y, x) = {static_cast<float>(position.x), static_cast<float>(position.y)};
    }
  background_ = warp::sample(picture->image, map, {warp::Filter::kBicubic, warp::Border::kClamp});
}

double Renderer::time_of(int frame) const noexcept {
  const project::Output& output = project_.output;
  if (output.frames <= 1) return 0;
  return std::clamp(static_cast<double>(frame - output.start) / (output.frames - 1), 0.0, 1.0);
}

warp::Image Renderer::frame(double t) const {
  const std::vector<warp::FieldLine> lines = field_lines(pairs_, t);
  const double whole = std::clamp(motion::progress(*project::effective(project_).dissolve, t), 0.0, 1.0);
  const auto [least, most] =
      std::minmax_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  const bool local = local_dissolve_ && least->value != most->value;
  const double dissolve = local_dissolve_ ? least->value : whole;
  const Moment moment{warp::LineField(lines, 2), static_cast<float>(dissolve), local,
                      (local ? least->value : dissolve) < 1, (local ? most->value : dissolve) > 0};
  warp::Image out(size_);
  warp::for_rows(size_.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) render_row(moment, y, row_of(out, y));
  });
  return out;
}

void Renderer::sample_side(const Side& side, std::span<warp::MapPoint> positions, std::span<warp::Pixel> out) const {
  to_image(side.held, positions);
  warp::sample_row(side.image, positions, {project_.warp.filter, side.border}, out);
}

void Renderer::render_row(const Moment& moment, int y, std::span<warp::Pixel> out) const {
  struct Scratch {
    std::vector<warp::MapPoint> source, destination;
    std::vector<warp::Pixel> pixels;
    std::vector<float> dissolve;
  };
  // Kept from row to row; only its sizes matter between uses.
  thread_local Scratch scratch;
  scratch.source.resize(out.size());
  scratch.destination.resize(out.size());
  scratch.pixels.resize(out.size());
  scratch.dissolve.resize(moment.local_dissolve ? out.size() : 0);

  const std::array<std::span<warp::MapPoint>, 2> positions{scratch.source, scratch.destination};
  moment.field.row(y, 0, positions, scratch.dissolve);
  if (!moment.needs_source) {
    sample_side(destination_, scratch.destination, out);
  } else {
    sample_side(source_, scratch.source, out);
    if (moment.needs_destination) {
      sample_side(destination_, scratch.destination, scratch.pixels);
      const std::span<const float> alpha = moment.local_dissolve ? std::span<const float>(scratch.dissolve)
                                                                 : std::span<const float>(&moment.dissolve, 1);
      dissolve_row(out, scratch.pixels, alpha, project_.blend);
    }
  }
  if (background_.empty()) return;
  const int row = background_.rows == 1 ? 0 : y;
  over_row(out, {background_[row], static_cast<std::size_t>(background_.cols)});
}

warp::Map Renderer::map(double t, SideName side_name) const {
  const warp::LineField field(field_lines(pairs_, t), 2);
  warp::Map map(size_);
  warp::for_rows(size_.height, [&](int begin, int end) {
    std::vector<warp::MapPoint> other(static_cast<std::size_t>(size_.width));
    for (int y = begin; y < end; ++y) {
      const std::span<warp::MapPoint> wanted(map[y], other.size());
      const std::span<warp::MapPoint> rest(other);
      const bool first = side_name == SideName::kSource;
      field.row(y, 0, std::array<std::span<warp::MapPoint>, 2>{first ? wanted : rest, first ? rest : wanted});
      to_image(side(side_name).file, wanted);
    }
  });
  return map;
}

}  // namespace morphkit::render
