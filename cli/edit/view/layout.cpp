#include "cli/edit/view/layout.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/edit/view/model.h"
#include "morph/project/words.h"

namespace morphkit::edit {
namespace {

// In units of the scale: px on a canvas of 1600x900.
constexpr double kMargin = 8, kGap = 4, kGroupGap = 18, kButton = 28;
constexpr double kLetter = 8.2, kPadding = 18;
constexpr double kSliderLabel = 27, kSliderValue = 62, kMinSlider = 140, kMaxSlider = 230;
constexpr double kMaxA = 100, kMaxB = 4;

double width_of(std::string_view label) {
  return kLetter * static_cast<double>(label.size()) + kPadding;
}

/// Lays widgets side by side, from one end of a strip.
class Row {
 public:
  Row(Layout& layout, const cv::Rect& strip, double begin) : layout_(layout), strip_(strip), at_(begin) {}

  Widget& add(Action action, std::string label, double width = 0) {
    Widget widget;
    widget.action = action;
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
  row.add(Command::kAddColumn, "+ Column").enabled = document.has_mesh();
  row.add(Command::kRemoveColumn, "- Column").enabled = selected;
  row.add(Command::kAddRow, "+ Row").enabled = document.has_mesh();
  row.add(Command::kRemoveRow, "- Row").enabled = selected;
}

void add_tools(Layout& layout, const Model& model) {
  Row row(layout, layout.top, kMargin);
  for (const ToolRow& tool : kTools) row.add(tool.tool, std::string(tool.label)).on = model.tool == tool.tool;
  row.gap();
  for (const SwitchRow& entry : kSwitches)
    row.add(entry.toggle, std::string(entry.label)).on = model.switches.*entry.toggle.flag;
  if (row_of(model.tool).edits == Edits::kMesh) add_mesh_buttons(row, model.document);
}

void add_commands(Layout& layout, const Model& model) {
  const struct {
    Command command;
    std::string_view label;
    bool enabled;
    bool on = false;
  } buttons[] = {{Command::kUndo, "Undo", model.document.can_undo() || model.sketch},
                 {Command::kRedo, "Redo", model.document.can_redo()},
                 {Command::kFit, "Fit", true},
                 {Command::kSave, "Save", model.document.changed()},
                 {Command::kHelp, "Help", true, model.help}};
  double width = kMargin;
  for (const auto& button : buttons) width += width_of(button.label) + kGap;
  Row row(layout, layout.top, layout.top.width / layout.scale - width);
  for (const auto& button : buttons) {
    Widget& widget = row.add(button.command, std::string(button.label));
    widget.enabled = button.enabled;
    widget.on = button.on;
  }
}

void add_shows(Layout& layout, const Model& model) {
  Row row(layout, layout.head(Pane::kResult), 0);
  for (const ShowRow& show : kShows)
    row.add(show.show, std::string(show.label), width_of(show.label) - 8).on = model.show == show.show;
}

std::string speed_text(double speed) {
  if (speed == 0.25) return "1/4x";
  if (speed == 0.5) return "1/2x";
  return std::to_string(static_cast<int>(speed)) + "x";
}

void add_time(Layout& layout, const Model& model) {
  constexpr double kPlay = 66, kSpeed = 48, kValue = 144;
  Row row(layout, layout.time, kMargin);
  row.add(Command::kPlay, model.playing ? "Pause" : "Play", kPlay).on = model.playing;
  row.gap(kMargin);
  const double total = layout.time.width / layout.scale;
  row.add(TimeSlider{}, "", total - row.at() - kValue - kSpeed - 2 * kMargin).slider = model.t;
  Row right(layout, layout.time, total - kSpeed - kMargin);
  right.add(Command::kNextSpeed, speed_text(model.speed), kSpeed);
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
  const double slider = std::clamp(room / 3 - kGap, kMinSlider, kMaxSlider);

  Row row(layout, layout.tuning, kTarget);
  const std::pair<Tuning, const char*> sliders[] = {{Tuning::kA, "a"}, {Tuning::kB, "b"}, {Tuning::kP, "p"}};
  for (const auto& [which, label] : sliders) {
    Widget& widget = row.add(which, label, slider);
    widget.slider = slider_from_tuning(which, document.tuning(which));
    widget.on = document.tuning_is_own(which);
  }
  row.gap();
  row.add(TimingKind::kShape, "Shape: " + easing_name(document.timing(TimingKind::kShape).easing), kEasing);
  row.add(TimingKind::kDissolve, "Mix: " + easing_name(document.timing(TimingKind::kDissolve).easing), kEasing);
  row.add(Command::kInherit, "Inherit").enabled = !model.document.selection().features.empty();
  row.gap();
  double widest = 0;
  for (const auto& [word, method] : project::Words<project::MethodName>::kTable)
    widest = std::max(widest, width_of(fmt::format("Warp: {}", word)));
  row.add(Command::kNextMethod, fmt::format("Warp: {}", project::word_of(document.method())), widest);
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
    row.add(Answer{answer.key}, answer.label, width_of(answer.label) + 14);
    row.gap(kGap);
  }
}

}  // namespace

Layout layout_of(const Model& model) {
  if (!model.question) return layout_beneath(model);
  Layout layout{panes_of(model.canvas_size), {}, {}};
  add_question(layout, model);
  return layout;
}

Layout layout_beneath(const Model& model) {
  Layout layout{panes_of(model.canvas_size), {}, {}};
  add_tools(layout, model);
  add_commands(layout, model);
  add_shows(layout, model);
  add_time(layout, model);
  add_tuning(layout, model);
  return layout;
}

const Widget* Layout::widget_at(cv::Point position) const {
  const auto found =
      std::find_if(widgets.rbegin(), widgets.rend(), [&](const Widget& w) { return w.rect.contains(position); });
  return found == widgets.rend() ? nullptr : &*found;
}

double tuning_from_slider(Tuning which, double slider) {
  // No finer than the value beside the slider is shown.
  const double knob = std::clamp(slider, 0.0, 1.0);
  const auto hundredths = [](double value) { return std::round(100 * value) / 100; };
  switch (which) {
    case Tuning::kA:
      return hundredths(kMaxA * knob * knob);
    case Tuning::kB:
      return hundredths(kMaxB * knob);
    case Tuning::kP:
      return hundredths(knob);
  }
  return knob;
}

double slider_from_tuning(Tuning which, double value) {
  switch (which) {
    case Tuning::kA:
      return std::clamp(std::sqrt(value / kMaxA), 0.0, 1.0);
    case Tuning::kB:
      return std::clamp(value / kMaxB, 0.0, 1.0);
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
