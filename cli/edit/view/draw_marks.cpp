#include "cli/edit/view/draw_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "cli/edit/document/marks.h"
#include "cli/edit/view/paint.h"
#include "cli/edit/view/picking.h"
#include "morph/render/warper.h"

namespace morphkit::edit {
namespace {

constexpr std::size_t kMaxNumbered = 32;  ///< with more features, only selected and hovered ones are numbered

/// Draws on one pane.
struct Pen {
  cv::Mat3b& pane;
  const View& view;
  double scale;
  const Type& type;

  cv::Point2d at(cv::Point2d picture) const { return view.to_pane(picture, pane.size()); }
  std::vector<cv::Point2d> at(const std::vector<cv::Point2d>& picture) const {
    std::vector<cv::Point2d> result;
    result.reserve(picture.size());
    for (const cv::Point2d& point : picture) result.push_back(at(point));
    return result;
  }
  int px(double units) const { return std::max(1, static_cast<int>(std::lround(units * scale))); }

  /// A line with a casing around it. A bright casing gets a dark one around itself.
  void cased(const std::vector<cv::Point2d>& points, const cv::Vec3b& color, const cv::Vec3b& casing,
             double thickness) const {
    if (casing != palette::kDark) stroke(pane, points, palette::kDark, px(thickness + 4.8));
    stroke(pane, points, casing, px(thickness + 2.4));
    stroke(pane, points, color, px(thickness));
  }
  void handle(cv::Point2d point, const cv::Vec3b& color, const cv::Vec3b& casing, double radius) const {
    if (casing != palette::kDark) disc(pane, point, (radius + 2.8) * scale, palette::kDark);
    disc(pane, point, (radius + 1.6) * scale, casing);
    disc(pane, point, radius * scale, color);
  }
};

struct Look {
  cv::Vec3b color, casing;
  double thickness;
  bool marked;  ///< selected or under the mouse
};

Look look_of(const Model& model, int feature) {
  const bool selected = std::ranges::binary_search(model.document.selection().features, feature);
  const bool under_mouse = model.hover && model.hover->feature == feature;
  Look look{feature_color(feature), palette::kDark, 1.8, selected || under_mouse};
  if (selected) {
    look.casing = palette::kLight;
    look.thickness = 2.4;
  }
  if (under_mouse) {
    look.color = mixed(look.color, palette::kLight, 0.35);
    look.thickness = 3;
  }
  return look;
}

void draw_arrow(const Pen& pen, const std::vector<cv::Point2d>& line, const Look& look) {
  const cv::Point2d tip = line.back();
  const double size = 11 * pen.scale;
  // The last point of the line that is one arrow length away from the tip.
  const auto away = [&](cv::Point2d at) { return std::hypot(tip.x - at.x, tip.y - at.y); };
  const auto from = std::find_if(line.rbegin(), line.rend(), [&](cv::Point2d at) { return away(at) >= size; });
  if (from == line.rend()) return;
  const cv::Point2d d = tip - *from;
  const double length = away(*from);
  const cv::Point2d along = d / length;
  const cv::Point2d across(-along.y, along.x);
  const cv::Point2d base = tip - along * (size + 4 * pen.scale);
  const cv::Point2d nose = tip - along * 4 * pen.scale;
  polygon(pen.pane, {nose, base + across * 0.42 * size, base - across * 0.42 * size}, look.color);
}

void draw_number(const Pen& pen, cv::Point2d at, int feature, const Look& look) {
  const std::string number = std::to_string(feature + 1);
  const int height = pen.px(12);
  const int width = pen.type.width(number, height);
  const cv::Point corner(cv::Point2d(at.x + 7 * pen.scale, at.y - 20 * pen.scale));
  const int margin = pen.px(4);
  fill(pen.pane, {corner.x, corner.y, width + 2 * margin, height + margin}, palette::kDark, pen.px(4), 0.7);
  pen.type.draw(pen.pane, number, {corner.x + margin, corner.y + height}, height,
                mixed(look.color, palette::kLight, 0.4));
}

void draw_feature(const Pen& pen, const Model& model, const project::Moment& moment, SideIndex side, int index) {
  const project::MomentFeature& feature = (*moment.features)[static_cast<std::size_t>(index)];
  const Look look = look_of(model, index);
  const std::vector<cv::Point2d> points = pen.at(feature.places[side]);
  const std::vector<cv::Point2d> outline = pen.at(outline_of(feature.mark, feature.places[side]));
  if (outline.size() > 1) {
    pen.cased(outline, look.color, look.casing, look.thickness);
    if (!is_closed(feature.mark)) draw_arrow(pen, outline, look);
  }
  const bool point = std::holds_alternative<project::Point>(feature.mark);
  const bool few = !std::holds_alternative<project::Curve>(feature.mark) || look.marked;
  for (const cv::Point2d& at : points) {
    pen.handle(at, look.color, look.casing, few ? 4.2 : 2.6);
    if (point) ring(pen.pane, at, 8.5 * pen.scale, look.color, pen.px(1.6));
  }
  const auto& held = model.held ? model.held : model.hover;
  if (held && held->feature == index && held->point >= 0 && static_cast<std::size_t>(held->point) < points.size())
    ring(pen.pane, points[static_cast<std::size_t>(held->point)], 8 * pen.scale, palette::kLight, pen.px(1.6));
  if (look.marked || moment.features->size() <= kMaxNumbered)
    draw_number(pen, outline[outline.size() / 2], index, look);
}

void draw_mesh(const Pen& pen, const Model& model, const project::Moment& moment, SideIndex side) {
  const project::MomentMesh& mesh = *moment.mesh;
  const std::vector<cv::Point2d> vertices = pen.at(vertices_of(model, moment, side));
  const auto vertex = [&](int column, int row) {
    return vertices[static_cast<std::size_t>(row) * static_cast<std::size_t>(mesh.columns) +
                    static_cast<std::size_t>(column)];
  };
  const bool active = row_of(model.tool).edits == Edits::kMesh;
  for (int pass = 0; pass < 2; ++pass) {
    const cv::Vec3b& color = pass == 0 ? palette::kDark : active ? palette::kMesh : palette::kQuiet;
    const int thickness = pen.px(pass == 0 ? 2.6 : 1);
    for (int row = 0; row < mesh.rows; ++row) {
      std::vector<cv::Point2d> line;
      line.reserve(static_cast<std::size_t>(mesh.columns));
      for (int column = 0; column < mesh.columns; ++column) line.push_back(vertex(column, row));
      stroke(pen.pane, line, color, thickness);
    }
    for (int column = 0; column < mesh.columns; ++column) {
      std::vector<cv::Point2d> line;
      line.reserve(static_cast<std::size_t>(mesh.rows));
      for (int row = 0; row < mesh.rows; ++row) line.push_back(vertex(column, row));
      stroke(pen.pane, line, color, thickness);
    }
  }
  if (!active) return;
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) {
    const bool selected = std::ranges::binary_search(model.document.selection().vertices, i);
    const bool under_mouse = model.hover && model.hover->vertex == i;
    pen.handle(vertices[static_cast<std::size_t>(i)], selected ? palette::kLight : palette::kMesh,
               under_mouse ? palette::kLight : palette::kDark, selected || under_mouse ? 4.6 : 3.4);
  }
}

void draw_sketch(const Pen& pen, const Sketch& sketch, int next) {
  const cv::Vec3b color = feature_color(next);
  if (sketch.shape == Sketch::Shape::kBox) {
    const cv::Point2d a = pen.at(sketch.points[0]);
    const cv::Point2d b = pen.at(sketch.points[1]);
    const cv::Rect2d band(a, b);
    fill(pen.pane, band, palette::kLight, 0, 0.12);
    stroke(pen.pane, {a, {b.x, a.y}, b, {a.x, b.y}, a}, palette::kLight, 1);
    return;
  }
  std::vector<cv::Point2d> points = pen.at(sketch.points);
  if (sketch.shape == Sketch::Shape::kCurve) {
    std::vector<cv::Point2d> through = sketch.points;
    if (sketch.next != through.back()) through.push_back(sketch.next);
    pen.cased(pen.at(outline_of(project::Curve{}, through)), color, palette::kDark, 2);
    if (points.size() > 2) ring(pen.pane, points.front(), 9 * pen.scale, palette::kLight, pen.px(1.6));
  } else {
    pen.cased(points, color, palette::kDark, 2);
  }
  for (const cv::Point2d& at : points) pen.handle(at, color, palette::kDark, 4.2);
}

void draw_snapped(const Pen& pen, cv::Point2d picture) {
  const cv::Point2d at = pen.at(picture);
  const double r = 9 * pen.scale;
  const std::vector<cv::Point2d> diamond{
      {at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}, {at.x, at.y - r}};
  pen.cased(diamond, palette::kLight, palette::kDark, 1.4);
}

}  // namespace

void draw_marks(cv::Mat3b& pane, const Model& model, SideIndex side, double scale, const Type& type) {
  const Pen pen{pane, model.view(pane_of(side)), scale, type};
  const bool mesh = row_of(model.tool).edits == Edits::kMesh;
  const project::Moment moment = model.moment();
  const int count = static_cast<int>(moment.features->size());
  if (model.switches.features) {
    if (moment.mesh && (mesh || std::holds_alternative<project::MeshMethod>(moment.method)))
      draw_mesh(pen, model, moment, side);
    // Selected and hovered features lie on top.
    for (const bool marked : {false, true})
      for (int i = 0; i < count && !mesh; ++i)
        if (look_of(model, i).marked == marked) draw_feature(pen, model, moment, side, i);
  }
  const std::optional<Handle>& held = model.held;
  const SideIndex active = model.sketch ? model.sketch->side : held ? held->side : side;
  if (model.sketch && model.sketch->side == side) draw_sketch(pen, *model.sketch, count);
  if (model.snapped && active == side) draw_snapped(pen, *model.snapped);
}

void draw_between(cv::Mat3b& pane, const Model& model, const LinesOf& lines_of, double scale) {
  const auto px = [&](double units) { return std::max(1, static_cast<int>(std::lround(units * scale))); };
  const auto worked_on = [&](int feature) {
    return (model.hover && model.hover->feature == feature) ||
           std::ranges::binary_search(model.document.selection().features, feature);
  };
  const project::Evaluator& moments = model.document.moments();
  /// All casings lie below all colours, because neighbours touch.
  const auto draw = [&](cv::Mat3b& picture, project::Time time, bool all, bool cased) {
    const project::Moment moment = moments.at(time);
    for (const bool casing : {true, false})
      for (const render::FeatureLine& whole : lines_of(moment)) {
        const int feature = static_cast<int>(whole.feature);
        if ((casing && !cased) || !(all || worked_on(feature))) continue;
        const warp::Line line = render::between(whole, moment);
        const cv::Point2d p = model.result_view.to_pane(line.p, picture.size());
        const cv::Point2d q = model.result_view.to_pane(line.q, picture.size());
        const cv::Vec3b color = casing ? palette::kDark : feature_color(feature);
        if (line.p == line.q) {
          disc(picture, p, (casing ? 4.2 : 3) * scale, color);
        } else {
          stroke(picture, {p, q}, color, px(casing ? 3.6 : 1.6));
        }
      }
  };
  if (model.switches.onion)
    for (const double t : render::kMoments) {
      cv::Mat3b skin = pane.clone();
      draw(skin, moments.clock().at(t), true, false);
      const double strength = 0.2 + 0.6 * (1 - std::min(1.0, 2 * std::abs(t - model.t)));
      cv::addWeighted(skin, strength, pane, 1 - strength, 0, pane);
    }
  // Without the onion skin only selected and hovered features, so that the picture can be judged.
  draw(pane, model.time(), model.switches.onion, true);
}

}  // namespace morphkit::edit
