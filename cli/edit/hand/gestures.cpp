#include "cli/edit/hand/gestures.h"

#include <utility>

#include "cli/edit/hand/slider_drag.h"
#include "cli/edit/hand/views.h"
#include "cli/edit/view/keys.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {

Gestures::Gestures(Model& model, EdgeFinder edges)
    : context_(model, std::move(edges)),
      tools_(context_),
      entry_(context_),
      playback_(model),
      actions_(context_, tools_, entry_, playback_) {}

std::optional<EditorRequest> Gestures::mouse(const Mouse& mouse) {
  model().mouse = mouse.position;
  std::optional<EditorRequest> request;
  switch (mouse.what) {
    case Mouse::What::kPress:
      request = press(mouse, false);
      break;
    case Mouse::What::kDoubleClick:
      request = press(mouse, true);
      break;
    case Mouse::What::kMove:
      move(mouse);
      break;
    case Mouse::What::kRelease:
      release(mouse);
      break;
    case Mouse::What::kWheel:
      zoom_by_wheel(model(), mouse);
      break;
  }
  update_hover();
  return request;
}

std::optional<EditorRequest> Gestures::press(const Mouse& mouse, bool again) {
  release(mouse);  // if the release of the last press was lost
  if (model().help && !model().question) {
    model().help = false;
    return std::nullopt;
  }
  model().welcome = false;
  const Layout layout = layout_of(model());
  const Widget* widget = layout.widget_at(mouse.position);
  const std::optional<Pane> pane = layout.pane_at(mouse.position);
  // Before anything else, because the press may select other marks than those that the entry is for.
  if (model().entry && !model().question && (widget != nullptr || pane)) entry_.accept();
  if (widget != nullptr)
    return mouse.button == Mouse::Button::kLeft ? press_widget(*widget, mouse.position) : std::nullopt;
  if (!model().question && pane) press_pane({mouse, again, *pane, context_.content_at(*pane, mouse.position)});
  return std::nullopt;
}

std::optional<EditorRequest> Gestures::press_widget(const Widget& widget, cv::Point position) {
  if (!widget.enabled) return std::nullopt;
  if (!widget.slider) return actions_.perform(widget.action);
  if (slider_grip(widget, context_.panes().scale).contains(position))
    drag_ = std::make_unique<SliderDrag>(context_, widget, position);
  return std::nullopt;
}

void Gestures::press_pane(const Press& press) {
  const bool left = press.mouse.button == Mouse::Button::kLeft;
  if (left && press.pane != Pane::kResult) {
    context_.set_pressed_side(side_of(press.pane));
    drag_ = tools_.current().press(press);
  } else if (left && press.again) {
    model().fit_views();
  } else {
    drag_ = std::make_unique<PanDrag>(context_, press);
  }
}

void Gestures::move(const Mouse& mouse) {
  if (drag_) {
    drag_->move(mouse);
  } else {
    tools_.current().hover(mouse);
  }
}

void Gestures::release(const Mouse& mouse) {
  if (!drag_) return;
  std::exchange(drag_, nullptr)->release(mouse);
  model().snapped.reset();
}

std::optional<EditorRequest> Gestures::key(int key) {
  const std::optional<EditorRequest> request = press_key(key);
  update_hover();
  return request;
}

std::optional<EditorRequest> Gestures::press_key(int key) {
  if (model().question) {
    answer_question(model(), key);
  } else if (model().entry) {
    entry_.key(key);
  } else if (model().help && key != kKeyShift) {
    model().help = false;
  } else if (key == kKeyShift) {
    // It announces another key.
  } else if (drag_) {
    if (key == kKeyEscape) cancel_drag();
  } else {
    model().welcome = false;
    if (const std::optional<Action> action = action_of(key)) return actions_.perform(*action);
  }
  return std::nullopt;
}

void Gestures::cancel_drag() {
  model().welcome = false;
  drag_.reset();
  model().sketch.reset();
  model().snapped.reset();
  model().held.reset();
  if (model().document.in_step()) model().document.cancel();
}

void Gestures::update_hover() {
  const bool free = !drag_ && !model().question && !model().help;
  model().hover = free ? hit_test(model(), context_.panes(), model().mouse) : std::nullopt;
}

}  // namespace morphkit::edit
