#include "morph/render/renderer.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "morph/render/dissolve.h"
#include "warp/image/color.h"

namespace morphkit::render {
namespace {

warp::Pixel premultiplied(const project::Color& color) {
  const auto alpha = static_cast<float>(color.a);
  return {warp::linear_from_srgb(static_cast<float>(color.r)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.g)) * alpha,
          warp::linear_from_srgb(static_cast<float>(color.b)) * alpha, alpha};
}

}  // namespace

Renderer::Renderer(project::Project project, const Pictures& pictures, const RendererOptions& options) {
  auto body = std::make_unique<Body>(Body{std::move(project), {}});
  body->stage = make_stage(body->project, pictures);
  body_ = std::move(body);
  morpher_ = make_morpher(body_->project, body_->stage, options.allow_folds);
  make_background(pictures.background);
  const auto transparent = [](const media::Picture& picture, const StageSide& side) {
    return picture.info.has_alpha || picture.nonfinite_pixels > 0 || side.border == warp::Border::kTransparent;
  };
  const bool opaque_behind =
      pictures.background ? !pictures.background->info.has_alpha : !background_.empty() && background_(0, 0)[3] >= 1;
  has_alpha_ = !opaque_behind &&
               (transparent(pictures.source, stage().source) || transparent(pictures.destination, stage().destination));
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

void Renderer::make_background(const std::optional<media::Picture>& picture) {
  if (!picture) {
    const auto* color = std::get_if<project::Color>(&project().output.background);
    if (color != nullptr && color->a > 0) background_ = warp::Image(1, 1, premultiplied(*color));
    return;
  }
  const Placement placement = place(picture->image.size(), size(), project::Fit::kCover);
  warp::Map map(size());
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const cv::Point2d position = placement.to_image({x + 0.5, y + 0.5});
      map(y, x) = {static_cast<float>(position.x), static_cast<float>(position.y)};
    }
  background_ = warp::sample(picture->image, map, {warp::Filter::kArea, warp::Border::kClamp});
}

double Renderer::time_of(int frame) const noexcept {
  const project::Output& output = project().output;
  if (output.frames <= 1) return 0;
  return std::clamp(static_cast<double>(frame - output.start) / (output.frames - 1), 0.0, 1.0);
}

std::size_t Renderer::frame_bytes() const {
  return static_cast<std::size_t>(size().area()) * sizeof(warp::Pixel) + morpher_->scratch_bytes();
}

warp::Image Renderer::frame(double t) const {
  warp::Image out = morpher_->frame(t);
  if (background_.empty()) return out;
  for_rows(out.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int row = background_.rows == 1 ? 0 : y;
      over_row({out[y], static_cast<std::size_t>(out.cols)},
               {background_[row], static_cast<std::size_t>(background_.cols)});
    }
  });
  return out;
}

}  // namespace morphkit::render
