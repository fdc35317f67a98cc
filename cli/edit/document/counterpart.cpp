#include "cli/edit/document/counterpart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "cli/edit/document/document.h"
#include "cli/edit/document/marks.h"
#include "morph/render/inbetween.h"
#include "warp/field/line_field.h"
#include "warp/mesh/mesh.h"

namespace morphkit::edit {
namespace {

using project::SideIndex;

cv::Point2d into(cv::Point2d position, cv::Size picture) {
  return {std::clamp(position.x, 0.0, static_cast<double>(picture.width)),
          std::clamp(position.y, 0.0, static_cast<double>(picture.height))};
}

/// Whether warp::LineField accepts the line.
bool in_range(const warp::Line& line) {
  constexpr double kMost = 1e9;
  return std::max({std::abs(line.p.x), std::abs(line.p.y), std::abs(line.q.x), std::abs(line.q.y)}) <= kMost;
}

const cv::Point2d kCentre{0.5, 0.5};

/// The lines of `side` as the output and those of the other as the target, all moved so that `on_canvas` is the centre
/// of pixel (0, 0): the field is evaluated at pixel centres, and is most precise for small positions. A tiny line that
/// rounding makes a point on only one side carries no information and is left out.
std::vector<warp::FieldLine> lines_about(const std::vector<render::FeatureLine>& all,
                                         const std::vector<project::MomentFeature>& features, SideIndex side,
                                         cv::Point2d on_canvas) {
  const cv::Point2d shift = kCentre - on_canvas;
  std::vector<warp::FieldLine> lines;
  lines.reserve(all.size());
  for (const render::FeatureLine& both : all) {
    const warp::Line& here = both.sides[side];
    const warp::Line& there = both.sides[other(side)];
    const warp::Line output{here.p + shift, here.q + shift}, target{there.p + shift, there.q + shift};
    if ((output.p == output.q) != (target.p == target.q) || !in_range(output) || !in_range(target)) continue;
    warp::FieldLine line;
    line.output = output;
    line.targets = {target};
    line.weight = features[both.feature].weight;
    line.scale = features[both.feature].scale;
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Canvas to canvas; nullopt if the features give nothing there.
std::optional<cv::Point2d> carried_by_lines(const std::vector<project::MomentFeature>& features,
                                            std::span<const render::Placement> placements, SideIndex side,
                                            cv::Point2d on_canvas) {
  const std::vector<warp::FieldLine> lines =
      lines_about(render::feature_lines(features, placements), features, side, on_canvas);
  if (lines.empty()) return std::nullopt;
  std::array<warp::Map, 1> maps{warp::Map(1, 1)};
  warp::LineField(lines, 1).reference({0, 0, 1, 1}, maps);
  const cv::Vec2f there = maps[0](0, 0);
  const cv::Point2d position = cv::Point2d(there[0], there[1]) - kCentre + on_canvas;
  return finite(position) ? std::optional(position) : std::nullopt;
}

/// Weights of the corners a, b, c of a triangle at x, which add up to 1; nullopt for a triangle without area.
std::optional<std::array<double, 3>> weights_in(cv::Point2d a, cv::Point2d b, cv::Point2d c, cv::Point2d x) {
  const double area = (b - a).cross(c - a);
  if (area == 0) return std::nullopt;
  const double at_b = (x - a).cross(c - a) / area, at_c = (b - a).cross(x - a) / area;
  return std::array{1 - at_b - at_c, at_b, at_c};
}

/// Picture to picture: maps the triangle that contains x, or is nearest to x, to its partner.
std::optional<cv::Point2d> carried_by_mesh(const warp::Mesh& here, const warp::Mesh& there, cv::Point2d x) {
  double best = -std::numeric_limits<double>::infinity();
  std::optional<cv::Point2d> result;
  const auto look_at = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto weights = weights_in(here.vertices[a], here.vertices[b], here.vertices[c], x);
    if (!weights) return;
    const double inside = std::ranges::min(*weights);
    if (!(inside > best)) return;
    best = inside;
    const auto& [at_a, at_b, at_c] = *weights;
    result = at_a * there.vertices[a] + at_b * there.vertices[b] + at_c * there.vertices[c];
  };
  for (int row = 0; row + 1 < here.rows; ++row) {
    for (int column = 0; column + 1 < here.columns; ++column) {
      const std::size_t corner = here.index(column, row), across = here.index(column + 1, row + 1);
      look_at(corner, here.index(column + 1, row), across);
      look_at(corner, across, here.index(column, row + 1));
    }
  }
  return result && finite(*result) ? result : std::nullopt;
}

}  // namespace

project::Points vertices_on(cv::Size picture, int columns, int rows, const project::Points& listed) {
  if (!listed.empty()) return listed;
  return warp::uniform_mesh(columns, rows, {{0, 0}, cv::Size2d(picture)}).vertices;
}

cv::Point2d counterpart(const project::Project& project, const project::Moment& moment, cv::Size source,
                        cv::Size destination, SideIndex side, cv::Point2d position) {
  const std::array sizes{source, destination};
  const cv::Size here = sizes[side], there = sizes[other(side)];
  const cv::Size canvas = render::canvas_size(project, source);
  const std::array placements{render::place(source, canvas, project.output.fit),
                              render::place(destination, canvas, project.output.fit)};
  const cv::Point2d on_canvas = placements[side].to_canvas(position);
  if (std::holds_alternative<project::MeshMethod>(moment.method) && moment.mesh) {
    const auto mesh_on = [&](SideIndex which) {
      const project::MomentMesh& mesh = *moment.mesh;
      return warp::Mesh{mesh.columns, mesh.rows,
                        vertices_on(sizes[which], mesh.columns, mesh.rows, mesh.vertices[which])};
    };
    const auto carried = carried_by_mesh(mesh_on(side), mesh_on(other(side)), into(position, here));
    if (carried) return into(*carried, there);
  } else if (!moment.features->empty()) {
    if (const auto carried = carried_by_lines(*moment.features, placements, side, on_canvas))
      return into(placements[other(side)].to_image(*carried), there);
  }
  return into(placements[other(side)].to_image(on_canvas), there);
}

}  // namespace morphkit::edit
