#include "cli/edit/view/layout.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "cli/edit/view/model.h"

namespace morphkit::edit {
namespace {

// In units of the scale: px on a canvas of 1600x900.
constexpr double kTop = 46, kHead = 32, kTime = 44, kTuningStrip = 46, kStatus = 30;
constexpr double kMargin = 8, kGap = 4, kGroupGap = 18, kButton = 28;
constexpr double kLetter = 8.2, kPadding = 18;
constexpr double kSliderLabel = 27, kSliderValue = 62, kLeastSlider = 140, kMostSlider = 230;
constexpr double kMostA = 100, kMostB = 4;

double scale_of(cv::Size canvas) {
  return std::clamp(std::min(canvas.width / 1600.0, canvas.height / 900.0), 0.72, 2.0);
}

double width_of(std::string_view label) {
  return kLetter * static_cast<double>(label.size()) + kPadding;
}

/// Lays widgets side by side, from one end of a strip.
class Row {
 public:
  Row(Layout& layout, const cv::Rect& strip, double begin) : layout_(layout), strip_(strip), at_(begin) {}

  Widget& add(Action action, int value, std::string label, double width = 0) {
    Widget widget;
    widget.action = action;
    widget.value = value;
    const double scale = layout_.scale;
    const double units = width > 0 ? width : width_of(label);
    widget.label = std::move(label);
    const int height = static_cast<int>(std::lround(kButton * scale));
    widget.rect = {strip_.x + static_cast<int>(std::lround(at_ * scale)), strip_.y + (strip_.height - height) / 2,
                   static_cast<int>(std::lround(units * scale)), height};
    at_ += units + kGap;
    layout_.widgets.push_back(std::move(widget));
    return layout_.widgets.back();
  }

  void gap(double units = kGroupGap) { at_ += units; }
  double at() const { return at_; }

 private:
  Layout& layout_;
  cv::Rect strip_;
  double at_;
};

void add_mesh_buttons(Row& row, const Document& document) {
  const bool selected = !document.selection().vertices.empty();
  row.gap();
  row.add(Action::kAddColumn, 0, "+ Column").enabled = document.has_mesh();
  row.add(Action::kRemoveColumn, 0, "- Column").enabled = selected;
  row.add(Action::kAddRow, 0, "+ Row").enabled = document.has_mesh();
  row.add(Action::kRemoveRow, 0, "- Row").enabled = selected;
}

void add_tools(Layout& layout, const Model& model) {
  Row row(layout, layout.top, kMargin);
  const std::string_view tools[] = {"Select", "Line", "Point", "Curve", "Mesh"};
  for (int i = 0; i < 5; ++i) row.add(Action::kTool, i, std::string(tools[i])).on = model.tool == static_cast<Tool>(i);
  row.gap();
  const Switches& on = model.switches;
  row.add(Action::kLock, 0, "Lock").on = on.locked;
  row.add(Action::kSnap, 0, "Snap").on = on.snap;
  row.add(Action::kFeatures, 0, "Marks").on = on.features;
  row.add(Action::kOnion, 0, "Onion").on = on.onion;
  row.add(Action::kFolds, 0, "Folds").on = on.folds;
  row.add(Action::kLoupe, 0, "Loupe").on = on.loupe;
  if (model.tool == Tool::kMesh) add_mesh_buttons(row, model.document);
  const std::string_view commands[] = {"Undo", "Redo", "Fit", "Save", "Help"};
  double width = kMargin;
  for (const std::string_view command : commands) width += width_of(command) + kGap;
  Row right(layout, layout.top, layout.top.width / layout.scale - width);
  right.add(Action::kUndo, 0, "Undo").enabled = model.document.can_undo() || model.sketch;
  right.add(Action::kRedo, 0, "Redo").enabled = model.document.can_redo();
  right.add(Action::kFit, 0, "Fit");
  right.add(Action::kSave, 0, "Save").enabled = model.document.changed();
  right.add(Action::kHelp, 0, "Help").on = model.help;
}

void add_shows(Layout& layout, const Model& model) {
  const std::string_view shows[] = {"Dissolve", "Source", "Destination", "Difference", "Grid"};
  Row row(layout, layout.head(Pane::kResult), 0);
  for (int i = 0; i < 5; ++i)
    row.add(Action::kShow, i, std::string(shows[i]), width_of(shows[i]) - 8).on = model.show == static_cast<Show>(i);
}

std::string speed_text(double speed) {
  if (speed == 0.25) return "1/4x";
  if (speed == 0.5) return "1/2x";
  return std::to_string(static_cast<int>(speed)) + "x";
}

void add_time(Layout& layout, const Model& model) {
  constexpr double kPlay = 66, kSpeed = 48, kValue = 144;
  Row row(layout, layout.time, kMargin);
  row.add(Action::kPlay, 0, model.playing ? "Pause" : "Play", kPlay).on = model.playing;
  row.gap(kMargin);
  const double total = layout.time.width / layout.scale;
  row.add(Action::kTime, 0, "", total - row.at() - kValue - kSpeed - 2 * kMargin).slider = model.t;
  Row right(layout, layout.time, total - kSpeed - kMargin);
  right.add(Action::kSpeed, 0, speed_text(model.speed), kSpeed);
}

std::string easing_name(const motion::Easing& easing) {
  const std::string_view names[] = {"linear", "sine", "sinusoidal", "parabolic", "bezier", "step", "keys"};
  return std::string(names[easing.index()]);
}

void add_tuning(Layout& layout, const Model& model) {
  constexpr double kTarget = 116, kEasing = 146;
  const Document& document = model.document;
  const double buttons = kTarget + 2 * (kEasing + kGap) + width_of("Inherit") + width_of("Warp: lines") + 3 * kGroupGap;
  const double room = layout.tuning.width / layout.scale - buttons;
  const double slider = std::clamp(room / 3 - kGap, kLeastSlider, kMostSlider);

  Row row(layout, layout.tuning, kTarget);
  const std::string_view names[] = {"a", "b", "p"};
  for (int i = 0; i < 3; ++i) {
    Widget& widget = row.add(Action::kTune, i, std::string(names[i]), slider);
    widget.slider = slider_from_tuning(i, document.tuning(static_cast<Tuning>(i)));
    widget.on = document.tuning_is_own(static_cast<Tuning>(i));
  }
  row.gap();
  row.add(Action::kShape, 0, "Shape: " + easing_name(document.timing(Progress::kShape).easing), kEasing);
  row.add(Action::kDissolve, 0, "Mix: " + easing_name(document.timing(Progress::kDissolve).easing), kEasing);
  row.add(Action::kInherit, 0, "Inherit").enabled = !model.document.selection().features.empty();
  row.gap();
  const bool mesh = document.method() == project::MethodName::kMesh;
  row.add(Action::kMethod, 0, mesh ? "Warp: mesh" : "Warp: lines", width_of("Warp: lines"));
}

void add_question(Layout& layout, const Model& model) {
  const Question& question = *model.question;
  double answers = 0;
  for (const Question::Answer& answer : question.answers) answers += width_of(answer.label) + 14 + 2 * kGap;
  double wide = answers;
  for (const std::string& line : question.lines) wide = std::max(wide, kLetter * static_cast<double>(line.size()));
  wide = std::max(wide, 1.25 * kLetter * static_cast<double>(question.title.size()));
  const double scale = layout.scale;
  const double width = std::min(wide + 64, layout.top.width / scale - 40);
  const double height = 62 + 24 * static_cast<double>(question.lines.size()) + 60;
  const cv::Size size(static_cast<int>(width * scale), static_cast<int>(height * scale));
  layout.card = {(layout.top.width - size.width) / 2, (layout.status.br().y - size.height) / 2, size.width,
                 size.height};
  const int strip = static_cast<int>(56 * scale);
  Row row(layout, {layout.card.x, layout.card.br().y - strip, size.width, strip}, (width - answers) / 2);
  for (const Question::Answer& answer : question.answers) {
    row.add(Action::kAnswer, answer.key, answer.label, width_of(answer.label) + 14);
    row.gap(kGap);
  }
}

}  // namespace

Layout panes_of(cv::Size canvas) {
  Layout layout;
  layout.scale = scale_of(canvas);
  const auto px = [&](double units) { return static_cast<int>(std::lround(units * layout.scale)); };
  layout.top = {0, 0, canvas.width, px(kTop)};
  layout.status = {0, canvas.height - px(kStatus), canvas.width, px(kStatus)};
  layout.tuning = {0, layout.status.y - px(kTuningStrip), canvas.width, px(kTuningStrip)};
  layout.time = {0, layout.tuning.y - px(kTime), canvas.width, px(kTime)};
  const int head = layout.top.br().y;
  const int top = head + px(kHead);
  const int margin = px(kMargin);
  const int width = (canvas.width - 4 * margin) / 3;
  for (int i = 0; i < 3; ++i) {
    const int x = margin + i * (width + margin);
    layout.heads[i] = {x, head, width, px(kHead)};
    layout.panes[i] = {x, top, width, layout.time.y - top};
  }
  return layout;
}

Layout layout_of(const Model& model) {
  if (!model.question) return layout_beneath(model);
  Layout layout = panes_of(model.canvas_size);
  add_question(layout, model);
  return layout;
}

Layout layout_beneath(const Model& model) {
  Layout layout = panes_of(model.canvas_size);
  add_tools(layout, model);
  add_shows(layout, model);
  add_time(layout, model);
  add_tuning(layout, model);
  return layout;
}

std::optional<Pane> Layout::pane_at(cv::Point position) const {
  for (const Pane candidate : kPanes)
    if (pane(candidate).contains(position)) return candidate;
  return std::nullopt;
}

const Widget* Layout::widget_at(cv::Point position) const {
  const auto found =
      std::find_if(widgets.rbegin(), widgets.rend(), [&](const Widget& w) { return w.rect.contains(position); });
  return found == widgets.rend() ? nullptr : &*found;
}

double tuning_from_slider(int tuning, double slider) {
  // No finer than the value beside the slider is shown.
  const double knob = std::clamp(slider, 0.0, 1.0);
  const auto hundredths = [](double value) { return std::round(100 * value) / 100; };
  switch (static_cast<Tuning>(tuning)) {
    case Tuning::kA:
      return hundredths(kMostA * knob * knob);
    case Tuning::kB:
      return hundredths(kMostB * knob);
    case Tuning::kP:
      return hundredths(knob);
  }
  return knob;
}

double slider_from_tuning(int tuning, double value) {
  switch (static_cast<Tuning>(tuning)) {
    case Tuning::kA:
      return std::clamp(std::sqrt(value / kMostA), 0.0, 1.0);
    case Tuning::kB:
      return std::clamp(value / kMostB, 0.0, 1.0);
    case Tuning::kP:
      return std::clamp(value, 0.0, 1.0);
  }
  return value;
}

cv::Rect slider_track(const Widget& widget, double scale) {
  // The slider of t has its value beside it, not inside.
  const bool bare = widget.label.empty();
  const int left = static_cast<int>(std::lround((bare ? 8 : kSliderLabel) * scale));
  const int right = static_cast<int>(std::lround((bare ? 8 : kSliderValue) * scale));
  const int height = std::max(2, static_cast<int>(std::lround(4 * scale)));
  return {widget.rect.x + left, widget.rect.y + (widget.rect.height - height) / 2,
          std::max(1, widget.rect.width - left - right), height};
}

cv::Rect slider_grip(const Widget& widget, double scale) {
  const cv::Rect track = slider_track(widget, scale);
  const int knob = static_cast<int>(std::lround(8 * scale));
  return cv::Rect(track.x - knob, widget.rect.y, track.width + 2 * knob, widget.rect.height) & widget.rect;
}

}  // namespace morphkit::edit
