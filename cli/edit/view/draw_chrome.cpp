#include "cli/edit/view/draw_chrome.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "cli/edit/view/paint.h"
#include "cli/edit/view/picking.h"
#include "morph/project/clock.h"

namespace morphkit::edit {
namespace {

/// Writes text into rectangles.
struct Scribe {
  cv::Mat3b& canvas;
  const Layout& layout;
  const Type& type;
  int height = std::max(9, static_cast<int>(std::lround(kTypeHeight* layout.scale)));

  int px(double units) const { return static_cast<int>(std::lround(units * layout.scale)); }
  int width(std::string_view text) const { return type.width(text, height); }
  /// Left-aligned, centred in height, cut to fit.
  void left(const cv::Rect& rect, std::string_view text, const cv::Vec3b& color) const {
    type.draw(canvas, type.fitted(text, height, rect.width), {rect.x, baseline(rect)}, height, color);
  }
  void right(const cv::Rect& rect, std::string_view text, const cv::Vec3b& color) const {
    type.draw(canvas, text, {rect.br().x - width(text), baseline(rect)}, height, color);
  }
  void centred(const cv::Rect& rect, std::string_view text, const cv::Vec3b& color) const {
    const std::string fitted = type.fitted(text, height, rect.width);
    type.draw(canvas, fitted, {rect.x + (rect.width - width(fitted)) / 2, baseline(rect)}, height, color);
  }
  int baseline(const cv::Rect& rect) const { return rect.y + (rect.height + height * 3 / 4) / 2; }
};

std::string value_text(Tuning which, double value) {
  if (which == Tuning::kA) return fmt::format("{:.{}f} px", value, value < 10 ? 1 : 0);
  return fmt::format("{:.2f}", value);
}

void draw_slider(const Scribe& scribe, const Widget& widget, const Model& model) {
  const cv::Rect track = slider_track(widget, scribe.layout.scale);
  const double knob_x = track.x + *widget.slider * track.width;
  const double middle = track.y + track.height / 2.0;
  const Tuning* tuning = std::get_if<Tuning>(&widget.action);
  const bool inherited = tuning != nullptr && !widget.on && !model.document.selection().features.empty();
  const cv::Vec3b color = inherited ? palette::kFaint : palette::kAccent;
  fill(scribe.canvas, track, palette::kWidget, track.height / 2);
  fill(scribe.canvas, {track.x, track.y, static_cast<int>(knob_x) - track.x, track.height}, color, track.height / 2);
  disc(scribe.canvas, {knob_x, middle}, scribe.px(tuning != nullptr ? 6.5 : 8),
       inherited ? palette::kFaint : palette::kText);
  if (tuning == nullptr) return;
  const cv::Vec3b text = inherited ? palette::kFaint : palette::kText;
  scribe.left({widget.rect.x + scribe.px(4), widget.rect.y, track.x - widget.rect.x, widget.rect.height}, widget.label,
              text);
  const int room = scribe.px(50);
  scribe.left({widget.rect.br().x - room, widget.rect.y, room, widget.rect.height},
              value_text(*tuning, model.document.tuning(*tuning)), text);
}

void draw_titles(const Scribe& scribe, const Model& model) {
  const project::Project& project = model.document.project();
  const auto title = [&](Pane pane, std::string_view name, const std::filesystem::path& file) {
    cv::Rect rect = scribe.layout.head(pane);
    scribe.left(rect, name, palette::kText);
    const int used = scribe.width(name) + scribe.px(10);
    rect.x += used;
    rect.width -= used;
    scribe.left(rect, file.filename().string(), palette::kQuiet);
  };
  title(Pane::kSource, "Source", project.pictures[project::kSource].image);
  title(Pane::kDestination, "Destination", project.pictures[project::kDestination].image);
}

std::string_view hint(const Model& model) {
  const ToolRow& tool = row_of(model.tool);
  const bool no_mesh = !model.document.has_mesh() && !tool.hint_without_mesh.empty();
  return no_mesh ? tool.hint_without_mesh : tool.hint;
}

bool is_answer(const Widget& widget) {
  return std::holds_alternative<Answer>(widget.action);
}

std::string selection_text(const Model& model) {
  const Selection& selection = model.document.selection();
  if (!selection.vertices.empty())
    return fmt::format("{} {}", selection.vertices.size(), selection.vertices.size() == 1 ? "vertex" : "vertices");
  if (selection.features.empty()) return "Project";
  if (selection.features.size() > 1) return fmt::format("{} selected", selection.features.size());
  return model.document.project().features[static_cast<std::size_t>(selection.features.front())].id;
}

/// Mouse position and zoom of the pane under it.
std::string mouse_text(const Model& model, const Layout& layout) {
  const std::optional<Pane> pane = layout.pane_at(model.mouse);
  if (!pane) return "";
  const cv::Point2d at = to_content(model, layout, *pane, model.mouse);
  return fmt::format("{:.1f}, {:.1f} px    {:.0f} %", at.x, at.y, 100 * model.view(*pane).zoom);
}

void draw_status(const Scribe& scribe, const Model& model, const PreviewPicture& preview) {
  cv::Rect rect = scribe.layout.status;
  rect.x += scribe.px(12);
  rect.width -= scribe.px(24);
  if (model.entry) {
    const std::string_view what = model.entry->what == Entry::What::kName ? "Name: " : "Group (empty: none): ";
    scribe.right(rect, model.message, palette::kQuiet);
    return scribe.left(rect, fmt::format("{}{}\u258f", what, model.entry->text), palette::kText);
  }
  const bool changed = model.document.changed();
  const std::string file = model.file_name + (changed ? " *" : "");
  scribe.left(rect, file, changed ? palette::kText : palette::kQuiet);
  std::string right = mouse_text(model, scribe.layout);
  if (preview.fold_share > 0) right = fmt::format("folds: {:.1f} %    {}", 100 * preview.fold_share, right);
  scribe.right(rect, right, palette::kQuiet);
  const int used = scribe.width(file) + scribe.px(28);
  rect.x += used;
  rect.width -= used + scribe.width(right) + scribe.px(28);
  const bool said = !model.message.empty();
  const cv::Vec3b& color = !said ? palette::kQuiet : model.complaint ? palette::kAlert : palette::kText;
  scribe.left(rect, said ? std::string_view(model.message) : hint(model), color);
}

}  // namespace

void draw_widget(cv::Mat3b& canvas, const Widget& widget, const Layout& layout, const Model& model, const Type& type) {
  const Scribe scribe{canvas, layout, type};
  if (widget.slider) return draw_slider(scribe, widget, model);
  const bool reachable = widget.enabled && (!model.question || is_answer(widget));
  const bool under_mouse = reachable && widget.rect.contains(model.mouse);
  cv::Vec3b back = widget.on ? palette::kAccent : palette::kWidget;
  if (!widget.enabled) back = palette::kWidgetOff;
  if (under_mouse) back = mixed(back, palette::kLight, 0.12);
  fill(canvas, widget.rect, back, scribe.px(6));
  const cv::Vec3b& color = !widget.enabled ? palette::kFaint : widget.on ? palette::kLight : palette::kText;
  scribe.centred(widget.rect, widget.label, color);
}

void draw_chrome(cv::Mat3b& canvas, const Model& model, const Layout& layout, const PreviewPicture& preview,
                 const Type& type) {
  const Scribe scribe{canvas, layout, type};
  for (const cv::Rect& strip : {layout.top, layout.tuning, layout.status}) fill(canvas, strip, palette::kStrip);
  draw_titles(scribe, model);
  for (const Widget& widget : layout.widgets)
    if (!is_answer(widget)) draw_widget(canvas, widget, layout, model, type);
  cv::Rect target = layout.tuning;
  target.x += scribe.px(12);
  target.width = scribe.px(98);
  scribe.left(target, selection_text(model), palette::kQuiet);
  cv::Rect moment = layout.time;
  moment.width -= scribe.px(68);
  const double frame = project::Clock(model.document.project().output).at(model.t).frame;
  scribe.right(moment, fmt::format("t {:.3f}  frame {:.0f}", model.t, frame), palette::kText);
  draw_status(scribe, model, preview);
}

}  // namespace morphkit::edit
