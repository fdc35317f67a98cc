#include "cli/edit/view/picking.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "cli/edit/document/counterpart.h"
#include "morph/motion/curve.h"

namespace morphkit::edit {
namespace {

constexpr int kPiecesPerSegment = 16;

double distance(cv::Point2d a, cv::Point2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double distance_to_segment(cv::Point2d at, cv::Point2d p, cv::Point2d q) {
  const cv::Point2d d = q - p;
  const double squared = d.dot(d);
  const double u = squared > 0 ? std::clamp((at - p).dot(d) / squared, 0.0, 1.0) : 0.0;
  return distance(at, p + u * d);
}

/// Keeps the nearest of what it is shown.
struct Nearest {
  double distance;
  std::optional<Handle> handle;

  void offer(double candidate_distance, const Handle& candidate) {
    if (!(candidate_distance < distance)) return;
    distance = candidate_distance;
    handle = candidate;
  }
};

std::optional<Handle> vertex_at(const project::Points& vertices, SideIndex side, cv::Point2d at, double reach) {
  Nearest nearest{reach, {}};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    nearest.offer(distance(at, vertices[i]), {side, -1, -1, static_cast<int>(i)});
  return nearest.handle;
}

std::optional<Handle> point_at(const project::Moment& moment, SideIndex side, cv::Point2d at, double reach) {
  Nearest nearest{reach, {}};
  const std::vector<project::MomentFeature>& features = *moment.features;
  for (std::size_t f = 0; f < features.size(); ++f) {
    const project::Points& points = features[f].places[side];
    for (std::size_t p = 0; p < points.size(); ++p)
      nearest.offer(distance(at, points[p]), {side, static_cast<int>(f), static_cast<int>(p), -1});
  }
  return nearest.handle;
}

std::optional<Handle> body_at(const project::Moment& moment, SideIndex side, cv::Point2d at, double reach) {
  Nearest nearest{reach, {}};
  const std::vector<project::MomentFeature>& features = *moment.features;
  for (std::size_t f = 0; f < features.size(); ++f) {
    const std::vector<cv::Point2d> outline = outline_of(features[f].mark, features[f].places[side]);
    for (std::size_t i = 0; i + 1 < outline.size(); ++i)
      nearest.offer(distance_to_segment(at, outline[i], outline[i + 1]), {side, static_cast<int>(f), -1, -1});
  }
  return nearest.handle;
}

}  // namespace

cv::Point2d to_content(const Model& model, const Panes& panes, Pane pane, cv::Point2d canvas) {
  const cv::Rect& rect = panes.pane(pane);
  return model.view(pane).to_picture(canvas - cv::Point2d(rect.tl()), rect.size());
}

cv::Point2d to_canvas(const Model& model, const Panes& panes, Pane pane, cv::Point2d content) {
  const cv::Rect& rect = panes.pane(pane);
  return cv::Point2d(rect.tl()) + model.view(pane).to_pane(content, rect.size());
}

std::vector<cv::Point2d> outline_of(const project::Mark& mark, const project::Points& points) {
  const auto* shape = std::get_if<project::Curve>(&mark);
  if (shape == nullptr || motion::Curve::problem(shape->kind, points, shape->closed)) return points;
  const motion::Curve curve(shape->kind, points, shape->closed);
  const int pieces = curve.segments() * (shape->kind == motion::CurveKind::kPolyline ? 1 : kPiecesPerSegment);
  std::vector<cv::Point2d> outline;
  outline.reserve(static_cast<std::size_t>(pieces) + 1);
  for (int i = 0; i <= pieces; ++i) outline.push_back(curve.at(static_cast<double>(i) * curve.segments() / pieces));
  return outline;
}

project::Points vertices_of(const Model& model, const project::Moment& moment, SideIndex side) {
  const project::MomentMesh& mesh = *moment.mesh;
  return vertices_on(model.document.picture_size(side), mesh.columns, mesh.rows, mesh.vertices[side]);
}

std::optional<Handle> hit_test(const Model& model, const Panes& panes, cv::Point2d canvas) {
  const std::optional<Pane> pane = panes.pane_at(canvas);
  if (!pane || *pane == Pane::kResult || !model.switches.features) return std::nullopt;
  const SideIndex side = side_of(*pane);
  const cv::Point2d at = to_content(model, panes, *pane, canvas);
  const double px = panes.scale / model.view(*pane).zoom;
  const project::Moment moment = model.moment();
  if (row_of(model.tool).edits == Edits::kMesh) {
    if (!moment.mesh) return std::nullopt;
    return vertex_at(vertices_of(model, moment, side), side, at, kHandleReach * px);
  }
  const auto point = point_at(moment, side, at, kHandleReach * px);
  return point ? point : body_at(moment, side, at, kBodyReach * px);
}

cv::Point2d position_of(const Model& model, const Handle& handle) {
  const project::Moment moment = model.moment();
  if (handle.vertex >= 0) return vertices_of(model, moment, handle.side)[static_cast<std::size_t>(handle.vertex)];
  const project::MomentFeature& feature = (*moment.features)[static_cast<std::size_t>(handle.feature)];
  return feature.places[handle.side][static_cast<std::size_t>(std::max(0, handle.point))];
}

std::optional<MeshPlace> mesh_place_at(const Model& model, SideIndex side, cv::Point2d position) {
  const project::Moment moment = model.moment();
  if (!moment.mesh) return std::nullopt;
  const int columns = moment.mesh->columns;
  const int rows = moment.mesh->rows;
  const project::Points vertices = vertices_of(model, moment, side);
  const auto vertex = [&](int column, int row) {
    const int index = row * columns + column;
    return vertices[static_cast<std::size_t>(index)];
  };
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const cv::Point2d corners[] = {vertex(column, row), vertex(column + 1, row), vertex(column + 1, row + 1),
                                     vertex(column, row + 1)};
      const std::vector<cv::Point2f> quad(std::begin(corners), std::end(corners));
      if (cv::pointPolygonTest(quad, position, false) < 0) continue;
      const auto share = [](double before, double after) {
        return before + after > 0 ? before / (before + after) : 0.5;
      };
      return MeshPlace{column, row,
                       share(distance_to_segment(position, corners[0], corners[3]),
                             distance_to_segment(position, corners[1], corners[2])),
                       share(distance_to_segment(position, corners[0], corners[1]),
                             distance_to_segment(position, corners[3], corners[2]))};
    }
  return std::nullopt;
}

}  // namespace morphkit::edit
