#pragma once
// A hand at the preview tool, for tests of gestures: without pictures, files or a window.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/hand/gestures.h"
#include "cli/edit/view/keys.h"
#include "cli/edit/view/picking.h"
#include "morph/project/project.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::test {

inline const cv::Size kPicture(400, 300);
inline const cv::Size kWindow(1600, 900);  ///< where the layout's scale is 1

/// A hand at the tool. Pictures are shown one to one, so that whole positions of a picture can be pointed at exactly.
struct Hand {
  using What = edit::Mouse::What;
  using Button = edit::Mouse::Button;
  using Indices = std::vector<int>;

  explicit Hand(cv::Size destination = kPicture)
      : model(empty_project(), kPicture, destination, kWindow),
        gestures(model, [this](edit::SideIndex side, cv::Point2d position, double radius, double zoom) {
          asked = {radius, zoom};
          return edges ? edges(side, position) : std::nullopt;
        }) {
    model.fit_views();
    model.source_view = model.destination_view = {1, {200, 150}};
  }

  const edit::Document& document() const { return model.document; }
  const std::vector<project::Feature>& features() const { return document().project().features; }
  const Indices& selected() const { return document().selection().features; }
  edit::Layout layout() const { return edit::layout_of(model); }

  cv::Point at(edit::SideIndex side, cv::Point2d position) const {
    return edit::to_canvas(model, layout(), edit::pane_of(side), position);
  }
  cv::Point2d under(edit::Pane pane, cv::Point canvas) const { return edit::to_content(model, layout(), pane, canvas); }

  std::optional<edit::EditorRequest> mouse(What what, cv::Point position, Button button = Button::kLeft) {
    edit::Mouse event = keys;
    event.what = what;
    event.button = what == What::kMove ? Button::kNone : button;
    event.position = position;
    return gestures.mouse(event);
  }
  std::optional<edit::EditorRequest> press(edit::SideIndex side, cv::Point2d position) {
    return mouse(What::kPress, at(side, position));
  }
  void move(edit::SideIndex side, cv::Point2d position) { mouse(What::kMove, at(side, position)); }
  void release() { mouse(What::kRelease, model.mouse); }
  void drag(cv::Point from, cv::Point to, Button button = Button::kLeft) {
    mouse(What::kPress, from, button);
    mouse(What::kMove, (from + to) / 2);
    mouse(What::kMove, to);
    mouse(What::kRelease, to, button);
  }
  void drag(edit::SideIndex side, cv::Point2d from, cv::Point2d to) { drag(at(side, from), at(side, to)); }
  void click(edit::SideIndex side, cv::Point2d position) { drag(side, position, position); }
  void wheel(cv::Point position, double notches) {
    edit::Mouse event;
    event.what = What::kWheel;
    event.position = position;
    event.notches = notches;
    gestures.mouse(event);
  }
  std::optional<edit::EditorRequest> key(int code) { return gestures.key(code); }
  void type(const std::string& text) {
    for (const char c : text) key(c);
  }

  edit::Widget widget(const edit::Action& action) const {
    const std::vector<edit::Widget> all = layout().widgets;
    const auto found = std::ranges::find(all, action, &edit::Widget::action);
    return found == all.end() ? edit::Widget{} : *found;
  }
  std::optional<edit::EditorRequest> click(const edit::Action& action) {
    const cv::Rect rect = widget(action).rect;
    const cv::Point middle = (rect.tl() + rect.br()) / 2;
    const auto request = mouse(What::kPress, middle);
    mouse(What::kRelease, middle);
    return request;
  }
  cv::Point on_slider(const edit::Action& slider, double share) const {
    const cv::Rect track = edit::slider_track(widget(slider), layout().scale);
    return {track.x + static_cast<int>(share * track.width), track.y};
  }

  int steps_back() {
    int steps = 0;
    while (model.document.undo()) ++steps;
    return steps;
  }

  edit::Model model;
  std::function<std::optional<cv::Point2d>(edit::SideIndex, cv::Point2d)> edges;
  struct {
    double radius = 0, zoom = 0;
  } asked;
  edit::Mouse keys;  ///< Shift, Ctrl and Alt that are held
  edit::Gestures gestures;
};

class GestureSession : public testing::Test, public Hand {
 protected:
  void mark_three_lines() {
    for (const double y : {50.0, 150.0, 250.0}) drag(project::kSource, {100, y}, {300, y});
  }
};

}  // namespace morphkit::test
