#include "cli/edit/view/draw_overlays.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <opencv2/imgproc.hpp>

#include "cli/edit/view/draw_chrome.h"
#include "cli/edit/view/keys.h"
#include "cli/edit/view/paint.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

constexpr double kDim = 0.72;
constexpr double kLoupeZoom = 8;
constexpr double kLoupeRadius = 84;  ///< in units of the scale

int px(const Layout& layout, double units) {
  return static_cast<int>(std::lround(units * layout.scale));
}

/// The help in two columns of whole sections.
class HelpPage {
 public:
  HelpPage(const Type& type, cv::Size canvas, double scale)
      : type_(type), height_(std::max(9, static_cast<int>(std::lround(13 * scale)))), canvas_(canvas) {
    pitch_ = static_cast<int>(std::lround(height_ * 1.75));
    for (const KeyRow& line : key_rows()) keys_ = std::max(keys_, type.width(line.keys, height_));
    keys_ += 2 * height_;
    for (const KeyRow& line : key_rows())
      column_ = std::max(column_, keys_ + type.width(line.text, height_) + 3 * height_);
  }

  /// Rows of the longer column. The first section that begins below the middle begins the second column.
  int rows() const { return std::max(rows_of(lines().first(split())), rows_of(lines().subspan(split()))); }
  bool fits() const { return 2 * column_ + 4 * height_ <= canvas_.width && (rows() + 5) * pitch_ <= canvas_.height; }
  cv::Rect card() const {
    const cv::Size size(2 * column_ + 3 * height_, (rows() + 4) * pitch_);
    return {(canvas_.width - size.width) / 2, (canvas_.height - size.height) / 2, size.width, size.height};
  }

  void draw(cv::Mat3b& canvas) const {
    const cv::Rect card = this->card();
    fill(canvas, card, palette::kStrip, height_, 0.97);
    const cv::Point title(card.x + 2 * height_, card.y + static_cast<int>(2.6 * height_));
    type_.draw(canvas, "Keys and gestures", title, height_ * 5 / 4, palette::kLight);
    const std::string_view leave = "any key or click closes this";
    type_.draw(canvas, leave, {card.br().x - 2 * height_ - type_.width(leave, height_), title.y}, height_,
               palette::kQuiet);
    const int top = title.y + pitch_ / 2;
    draw_column(canvas, lines().first(split()), {title.x, top});
    draw_column(canvas, lines().subspan(split()), {title.x + column_, top});
  }

 private:
  static std::span<const KeyRow> lines() { return key_rows(); }
  static std::size_t split() {
    std::size_t at = lines().size() / 2;
    while (at < lines().size() && lines()[at].section == lines()[at - 1].section) ++at;
    return at;
  }
  static int rows_of(std::span<const KeyRow> lines) {
    int rows = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) rows += i == 0 || lines[i].section != lines[i - 1].section ? 3 : 1;
    return rows;
  }
  void draw_column(cv::Mat3b& canvas, std::span<const KeyRow> lines, cv::Point at) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i == 0 || lines[i].section != lines[i - 1].section) {
        at.y += 2 * pitch_ - pitch_ / 3;
        type_.draw(canvas, lines[i].section, at, height_, mixed(palette::kAccent, palette::kLight, 0.35));
        at.y += pitch_ / 3;
      }
      at.y += pitch_;
      type_.draw(canvas, lines[i].keys, at, height_, palette::kLight);
      type_.draw(canvas, lines[i].text, {at.x + keys_, at.y}, height_, palette::kText);
    }
  }

  const Type& type_;
  int height_;
  cv::Size canvas_;
  int pitch_ = 0;
  int keys_ = 0;
  int column_ = 0;
};

}  // namespace

void draw_help(cv::Mat3b& canvas, const Layout& layout, const Type& type) {
  fill(canvas, {{0, 0}, canvas.size()}, palette::kDark, 0, kDim);
  double scale = layout.scale * 1.1;
  while (scale > 0.5 && !HelpPage(type, canvas.size(), scale).fits()) scale *= 0.95;
  HelpPage(type, canvas.size(), scale).draw(canvas);
}

void draw_welcome(cv::Mat3b& canvas, const Layout& layout, const Type& type) {
  const std::string_view lines[] = {"1   Drag a line along something that both pictures have: a brow, an edge, a lip.",
                                    "2   Its partner appears on the other picture: drag its ends to where they belong.",
                                    "3   Watch the result. A dozen lines make a face; s saves, h shows every key."};
  const int height = px(layout, 16);
  int wide = 0;
  for (const std::string_view line : lines) wide = std::max(wide, type.width(line, height));
  const int pitch = height * 2;
  const cv::Size size(wide + 4 * height, pitch * 3 + 2 * height);
  const cv::Rect panes = layout.panes[0] | layout.panes[2];
  const cv::Rect card(panes.x + (panes.width - size.width) / 2, panes.br().y - size.height - px(layout, 40), size.width,
                      size.height);
  fill(canvas, card, palette::kDark, px(layout, 12), 0.84);
  cv::Point at(card.x + 2 * height, card.y + height / 2);
  for (const std::string_view line : lines) {
    at.y += pitch;
    type.draw(canvas, line, at, height, palette::kLight);
  }
}

void draw_question(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Type& type) {
  const Question& question = *model.question;
  fill(canvas, {{0, 0}, canvas.size()}, palette::kDark, 0, kDim);
  fill(canvas, layout.card, palette::kStrip, px(layout, 12));
  const auto centred = [&](std::string_view text, int y, int height, const cv::Vec3b& color) {
    const std::string fitted = type.fitted(text, height, layout.card.width - px(layout, 32));
    const int x = layout.card.x + (layout.card.width - type.width(fitted, height)) / 2;
    type.draw(canvas, fitted, {x, y}, height, color);
  };
  int y = layout.card.y + px(layout, 42);
  centred(question.title, y, px(layout, 17), palette::kLight);
  y += px(layout, 10);
  for (const std::string& line : question.lines)
    centred(line, y += px(layout, 24), px(layout, kTypeHeight), palette::kText);
  for (const Widget& widget : layout.widgets) draw_widget(canvas, widget, layout, model, type);
}

void draw_loupe(cv::Mat3b& canvas, const Model& model, const Layout& layout, const Pyramid& source,
                const Pyramid& destination) {
  const std::optional<Pane> pane = layout.pane_at(model.mouse);
  if (!pane || *pane == Pane::kResult) return;
  const Pyramid& picture = *pane == Pane::kSource ? source : destination;
  const double zoom = std::max(kLoupeZoom, 2 * model.view(*pane).zoom);
  const cv::Mat3b& pixels = picture.display(zoom);
  const cv::Point2d centre = to_content(model, layout, *pane, model.mouse);
  const int radius = px(layout, kLoupeRadius);
  const cv::Size size(2 * radius, 2 * radius);
  const cv::Matx23d map(1 / zoom, 0, centre.x - (radius - 0.5) / zoom - 0.5, 0, 1 / zoom,
                        centre.y - (radius - 0.5) / zoom - 0.5);
  cv::Mat3b magnified = placed(pixels, map, size, cv::INTER_NEAREST);
  const cv::Point2d middle(radius, radius);
  const double arm = 0.22 * radius;
  for (const cv::Vec3b& color : {palette::kDark, palette::kLight}) {
    const int thickness = color == palette::kDark ? 3 : 1;
    stroke(magnified, {middle - cv::Point2d(arm, 0), middle + cv::Point2d(arm, 0)}, color, thickness);
    stroke(magnified, {middle - cv::Point2d(0, arm), middle + cv::Point2d(0, arm)}, color, thickness);
  }
  // On the side of the mouse that has room.
  const cv::Rect& rect = layout.pane(*pane);
  const int gap = px(layout, 22);
  const bool left = model.mouse.x + gap + size.width > rect.br().x;
  const bool above = model.mouse.y + gap + size.height > rect.br().y;
  const cv::Point corner(left ? model.mouse.x - gap - size.width : model.mouse.x + gap,
                         above ? model.mouse.y - gap - size.height : model.mouse.y + gap);
  const cv::Rect target = cv::Rect(corner, size) & cv::Rect({0, 0}, canvas.size());
  if (target.empty()) return;
  cv::Mat1b mask(size, uchar{0});
  cv::circle(mask, {radius, radius}, radius - 2, cv::Scalar(255), cv::FILLED, cv::LINE_AA);
  const cv::Rect seen = target - corner;
  magnified(seen).copyTo(canvas(target), mask(seen));
  const cv::Point2d rim = cv::Point2d(corner) + middle;
  ring(canvas, rim, radius - 1, palette::kDark, 4);
  ring(canvas, rim, radius - 1, palette::kLight, 2);
}

}  // namespace morphkit::edit
