#include "cli/edit/view/preview.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "cli/edit/view/screen.h"
#include "morph/render/renderer.h"
#include "warp/analysis.h"

namespace morphkit::edit {
namespace {

constexpr double kGridCells = 20;         ///< of the displacement grid, over the longer side of the picture
const cv::Vec3b kFoldColor(40, 40, 235);  ///< BGR
const cv::Vec3b kGridColor(235, 235, 235);

render::FootagePicture scaled(const Pyramid& pyramid) {
  return {pyramid.size(), [&](double scale) { return pyramid.light(scale); }, true};
}

/// What of the pane shows a part of the canvas that is rendered.
cv::Rect visible_area(const PreviewRequest& request, cv::Size canvas) {
  const cv::Point2d first = request.view.to_pane({0, 0}, request.size);
  const cv::Point2d last = request.view.to_pane(cv::Point2d(canvas.width, canvas.height), request.size);
  // Clamped before they become whole numbers, which may not hold them.
  const auto whole = [](double edge, int limit) {
    return static_cast<int>(std::lround(std::clamp(edge, 0.0, static_cast<double>(limit))));
  };
  return {cv::Point(whole(first.x, request.size.width), whole(first.y, request.size.height)),
          cv::Point(whole(last.x, request.size.width), whole(last.y, request.size.height))};
}

render::CanvasView canvas_view(const PreviewRequest& request, const cv::Rect& area, int reduction) {
  const cv::Size size((area.width + reduction - 1) / reduction, (area.height + reduction - 1) / reduction);
  return {size, request.view.zoom / reduction, request.view.to_picture(area.tl(), request.size)};
}

/// A view of half the size, with the same pictures: for what needs their placement only.
render::Stage halved(render::Stage stage) {
  stage.size = {std::max(1, stage.size.width / 2), std::max(1, stage.size.height / 2)};
  stage.unit *= 2;
  for (render::StageSide& side : stage.sides) {
    for (render::Placement* placement : {&side.file, &side.held}) {
      placement->scale *= 0.5;
      placement->offset *= 0.5;
    }
  }
  return stage;
}

/// Lines where the map into the source crosses whole numbers of cells, about a pixel wide.
void draw_grid(const warp::Map& map, double cell, cv::Mat3b& screen) {
  const auto nearness = [&](int y, int x, int axis) {
    const int right = std::min(x + 1, map.cols - 1);
    const int below = std::min(y + 1, map.rows - 1);
    const double here = map(y, x)[axis] / cell;
    const double slope = std::hypot(map(y, right)[axis] / cell - here, map(below, x)[axis] / cell - here);
    const double distance = std::abs(here - std::round(here)) / std::max(slope, 1e-9);
    return std::clamp(1.2 - distance, 0.0, 1.0);
  };
  for_rows(map.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < map.cols; ++x) {
        const double line = 0.8 * std::max(nearness(y, x, 0), nearness(y, x, 1));
        cv::Vec3b& pixel = screen(y, x);
        for (int c = 0; c < 3; ++c) pixel[c] = cv::saturate_cast<uchar>((1 - line) * pixel[c] + line * kGridColor[c]);
      }
  });
}

/// A renderer of this project on a stage. Meshes that fold are shown as far as that goes.
render::Renderer renderer_of(const PreviewRequest& request, std::shared_ptr<const render::Stage> stage) {
  return {*request.project, std::move(stage), {.allow_folds = true}};
}

bool shows(const render::Renderer& renderer, const PreviewRequest& request, SideIndex side) {
  switch (request.show) {
    case Show::kSource:
      return side == project::kSource;
    case Show::kDestination:
      return side == project::kDestination;
    case Show::kDifference:
      return true;
    case Show::kDissolve:
    case Show::kGrid:
      break;
  }
  return renderer.shows(side, renderer.clock().at(request.t));
}

/// Paints red where a map of a side that shows turns over. @return the share of the pixels.
double paint_folds(const PreviewRequest& request, const render::Stage& stage, cv::Mat3b& screen) {
  const auto coarse = std::make_shared<const render::Stage>(halved(stage));
  const render::Renderer renderer = renderer_of(request, coarse);
  cv::Mat1b folded(coarse->size, uchar{0});
  for (SideIndex side = 0; side < coarse->sides.size(); ++side) {
    if (shows(renderer, request, side))
      folded |= warp::jacobian_determinant(renderer.map(renderer.clock().at(request.t), side)) <= 0;
  }
  const int count = cv::countNonZero(folded);
  if (count > 0) {
    cv::Mat1b mask;
    cv::resize(folded, mask, screen.size(), 0, 0, cv::INTER_NEAREST);
    cv::Mat3b red(screen.size(), kFoldColor);
    cv::addWeighted(screen, 0.45, red, 0.55, 0, red);
    red.copyTo(screen, mask);
  }
  return static_cast<double>(count) / static_cast<double>(folded.total());
}

cv::Mat3b shown(const PreviewRequest& request, const std::shared_ptr<const render::Stage>& stage) {
  const render::Renderer renderer = renderer_of(request, stage);
  const project::Time time = renderer.clock().at(request.t);
  const auto side = [&](SideIndex which) { return to_screen(renderer.side(time, which)); };
  if (request.show == Show::kSource) return side(project::kSource);
  if (request.show == Show::kDestination) return side(project::kDestination);
  if (request.show == Show::kDifference) {
    cv::Mat3b difference;
    cv::absdiff(side(project::kSource), side(project::kDestination), difference);
    return difference;
  }
  cv::Mat3b screen = to_screen(renderer.frame(time));
  if (request.show == Show::kGrid) {
    screen *= 0.6;
    const cv::Size size = renderer.picture_size(project::kSource);
    draw_grid(renderer.map(time, project::kSource), std::max(size.width, size.height) / kGridCells, screen);
  }
  return screen;
}

}  // namespace

const std::shared_ptr<const render::Stage>& PreviewRenderer::stage_of(const PreviewRequest& request,
                                                                      const cv::Rect& area, int reduction) {
  const project::Project& project = *request.project;
  const render::CanvasView view = canvas_view(request, area, reduction);
  std::optional<Placed>& placed = reduction > 1 ? placed_draft_ : placed_;
  const bool same = placed && placed->view.size == view.size && placed->view.zoom == view.zoom &&
                    placed->view.origin == view.origin && placed->border == project.warp.border &&
                    placed->output == project.output;
  if (same) return placed->stage;
  const render::Footage footage{{scaled(source_), scaled(destination_)},
                                background_ ? std::optional(scaled(*background_)) : std::nullopt};
  placed = Placed{view, project.warp.border, project.output,
                  std::make_shared<const render::Stage>(render::make_stage(project, footage, view))};
  return placed->stage;
}

PreviewPicture PreviewRenderer::render(const PreviewRequest& request, int reduction) {
  const auto begin = std::chrono::steady_clock::now();
  PreviewPicture picture;
  picture.number = request.number;
  picture.draft = reduction > 1;
  picture.area = visible_area(request, render::canvas_size(*request.project, source_.size()));
  if (picture.area.empty()) return picture;
  try {
    const std::shared_ptr<const render::Stage> stage = stage_of(request, picture.area, reduction);
    picture.image = shown(request, stage);
    if (request.folds) picture.fold_share = paint_folds(request, *stage, picture.image);
  } catch (const std::exception& error) {
    picture.image.release();
    picture.problem = error.what();
  }
  picture.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return picture;
}

}  // namespace morphkit::edit
