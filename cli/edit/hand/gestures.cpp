#include "cli/edit/hand/gestures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/edit/hand/snap.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

constexpr double kClickPx = 4;  ///< a drag that is shorter was a click
constexpr double kZoomPerNotch = 1.2;

double length(cv::Point2d d) {
  return std::hypot(d.x, d.y);
}

bool draws(Tool tool) {
  return tool == Tool::kLine || tool == Tool::kPoint || tool == Tool::kCurve;
}

/// The selection with `item` taken in, or taken out if it was in.
std::vector<int> toggled(std::vector<int> selected, int item) {
  const auto found = std::ranges::lower_bound(selected, item);
  if (found != selected.end() && *found == item) {
    selected.erase(found);
  } else {
    selected.insert(found, item);
  }
  return selected;
}

std::vector<int> united(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::sort(a);
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

}  // namespace

Gestures::Gestures(Model& model, EdgeFinder edges)
    : model_(model), edges_(std::move(edges)), layout_(layout_of(model)) {}

std::optional<Wish> Gestures::mouse(const Mouse& mouse) {
  model_.mouse = mouse.position;
  layout_ = layout_of(model_);
  std::optional<Wish> wish;
  switch (mouse.what) {
    case Mouse::What::kPress:
      wish = press(mouse, false);
      break;
    case Mouse::What::kDoubleClick:
      wish = press(mouse, true);
      break;
    case Mouse::What::kMove:
      drag_to(mouse);
      break;
    case Mouse::What::kRelease:
      release(mouse);
      break;
    case Mouse::What::kWheel:
      wheel(mouse);
      break;
  }
  const bool free = drag_ == Drag::kNothing && !model_.question && !model_.help;
  model_.hover = free ? handle_at(model_, layout_, mouse.position) : std::nullopt;
  return wish;
}

std::optional<Wish> Gestures::press(const Mouse& mouse, bool again) {
  if (drag_ != Drag::kNothing) release(mouse);  // its release was lost
  pressed_ = mouse.position;
  dragged_ = false;
  const bool left = mouse.button == Mouse::Button::kLeft;
  if (model_.help && !model_.question) {
    model_.help = false;
    return std::nullopt;
  }
  model_.welcome = false;
  const Widget* widget = layout_.widget_at(mouse.position);
  const std::optional<Pane> pane = layout_.pane_at(mouse.position);
  // First of all: what follows may select something else than what the entry is for.
  if (model_.entry && !model_.question && (widget || pane)) accept_entry();
  if (widget) return left ? press_widget(*widget, mouse.position) : std::nullopt;
  if (model_.question || !pane) return std::nullopt;
  pane_ = *pane;
  last_ = began_ = content_at(mouse.position);
  if (!left || pane_ == Pane::kResult) {
    if (again && left) {
      model_.fit_views();
    } else {
      drag_ = Drag::kPan;
    }
    return std::nullopt;
  }
  press_picture(mouse, again);
  return std::nullopt;
}

std::optional<Wish> Gestures::press_widget(const Widget& widget, cv::Point position) {
  if (!widget.enabled) return std::nullopt;
  if (!widget.slider) return act(widget.action, widget.value);
  if (!slider_grip(widget, layout_.scale).contains(position)) return std::nullopt;
  slider_ = widget;
  drag_ = Drag::kSlider;
  if (widget.action == Action::kTune) begin_step();
  slide(position);
  return std::nullopt;
}

void Gestures::press_picture(const Mouse& mouse, bool again) {
  side_ = side_of(pane_);
  if (model_.tool == Tool::kCurve && (model_.sketch || again)) return press_curve(mouse, again);
  const auto handle = handle_at(model_, layout_, mouse.position);
  if (handle && !(mouse.ctrl && draws(model_.tool))) return press_handle(*handle, mouse);
  if (again) return model_.fit_views();
  press_blank(mouse);
}

void Gestures::press_handle(const Handle& handle, const Mouse& mouse) {
  const bool vertex = handle.vertex >= 0;
  Selection selection = model_.document.selection();
  std::vector<int>& items = vertex ? selection.vertices : selection.features;
  const int item = vertex ? handle.vertex : handle.feature;
  if (mouse.shift || mouse.ctrl) {
    items = toggled(std::move(items), item);
    return select(std::move(selection));
  }
  if (!std::ranges::binary_search(items, item)) select(vertex ? Selection{{}, {item}} : Selection{{item}, {}});
  model_.held = handle;
  drag_ = vertex ? Drag::kVertices : handle.point >= 0 ? Drag::kPoint : Drag::kFeatures;
  from_ = position_of(model_.document, handle);
  begin_step();
  if (!vertex || model_.document.method() == project::MethodName::kMesh) return;
  say("the lines warp: \"Warp: lines\" below lets the mesh do it");
}

void Gestures::press_blank(const Mouse& mouse) {
  const SideIndex side = side_of(pane_);
  Document& document = model_.document;
  model_.switches.features = true;
  if (model_.tool == Tool::kMesh && !document.has_mesh()) {
    document.set_method(project::MethodName::kMesh);
    return say("a mesh on both pictures: drag its vertices");
  }
  if (mouse.shift || model_.tool == Tool::kSelect || model_.tool == Tool::kMesh) {
    adding_ = mouse.shift;
    drag_ = Drag::kBand;
    model_.sketch = Sketch{Tool::kSelect, side, {last_, last_}, last_};
    return;
  }
  const cv::Point2d at = snapped(last_, mouse, -1);
  if (model_.tool == Tool::kCurve) {
    model_.sketch = Sketch{Tool::kCurve, side, {at}, at};
    return say("click along the curve; Enter ends it, its first point closes it");
  }
  if (model_.tool == Tool::kPoint) {
    begin_step();
    const int feature = document.add_point(side, at);
    if (feature < 0) return end_step();
    model_.held = Handle{side, feature, 0, -1};
    from_ = at;
    drag_ = Drag::kPoint;
    return tell_of_new();
  }
  drag_ = Drag::kLine;
  model_.sketch = Sketch{Tool::kLine, side, {at, at}, at};
}

void Gestures::press_curve(const Mouse& mouse, bool again) {
  if (!model_.sketch || again) return end_curve(false);
  Sketch& sketch = *model_.sketch;
  if (sketch.side != side_of(pane_)) return end_curve(false);
  const double reach = kHandleReach * layout_.scale / model_.view(pane_).zoom;
  if (sketch.points.size() > 2 && length(last_ - sketch.points.front()) <= reach) return end_curve(true);
  sketch.next = snapped(last_, mouse, -1);
  sketch.points.push_back(sketch.next);
}

void Gestures::drag_to(const Mouse& mouse) {
  if (drag_ == Drag::kSlider) return slide(mouse.position);
  if (drag_ == Drag::kPan) return pan(mouse.position);
  if (model_.sketch && model_.sketch->tool == Tool::kCurve) {
    if (layout_.pane_at(mouse.position) != pane_of(model_.sketch->side)) return;
    pane_ = pane_of(model_.sketch->side);
    model_.sketch->next = snapped(content_at(mouse.position), mouse, -1);
    return;
  }
  if (drag_ == Drag::kNothing) return;
  // A hand that trembles while it clicks moves nothing.
  dragged_ = dragged_ || length(mouse.position - pressed_) >= kClickPx * layout_.scale;
  if (!dragged_) return;
  const cv::Point2d now = content_at(mouse.position);
  switch (drag_) {
    case Drag::kPoint:
    case Drag::kFeatures:
    case Drag::kVertices:
      drag_held(mouse, now - began_);
      break;
    case Drag::kLine:
      model_.sketch->points.back() = snapped(now, mouse, -1);
      break;
    default:
      model_.sketch->points.back() = now;
      break;
  }
  last_ = now;
}

void Gestures::drag_held(const Mouse& mouse, cv::Point2d by) {
  const SideIndex side = side_of(pane_);
  Document& document = model_.document;
  if (drag_ == Drag::kPoint) {
    const cv::Point2d to = by == cv::Point2d() ? from_ : snapped(from_ + by, mouse, model_.held->feature);
    document.move_point(model_.held->feature, side, model_.held->point, to);
    return;
  }
  by = rounded(by, model_.view(pane_).zoom);
  // From where all was at the press: what a border has held back is under the hand again when that comes back.
  document.cancel();
  document.begin();
  if (by == cv::Point2d()) return;
  if (drag_ == Drag::kVertices) {
    document.move_vertices(std::vector<int>(document.selection().vertices), side, by);
  } else {
    document.move_selected(side, by);
  }
}

void Gestures::release(const Mouse& mouse) {
  const Drag drag = std::exchange(drag_, Drag::kNothing);
  switch (drag) {
    case Drag::kLine:
      end_line(mouse.position);
      break;
    case Drag::kBand:
      end_band();
      break;
    case Drag::kPoint:
    case Drag::kFeatures:
    case Drag::kVertices:
      end_step();
      if (!dragged_) select_alone();
      break;
    case Drag::kSlider:
      end_step();
      break;
    default:
      break;
  }
  if (drag != Drag::kNothing) model_.snapped.reset();
}

void Gestures::select_alone() {
  const Handle held = *model_.held;
  const bool vertex = held.vertex >= 0;
  const Selection& selection = model_.document.selection();
  if ((vertex ? selection.vertices : selection.features).size() < 2) return;
  select(vertex ? Selection{{}, {held.vertex}} : Selection{{held.feature}, {}});
  model_.held = held;
}

void Gestures::end_line(cv::Point position) {
  const Sketch sketch = *std::exchange(model_.sketch, std::nullopt);
  if (length(position - pressed_) < kClickPx * layout_.scale) return select({});
  const int feature = model_.document.add_line(sketch.side, sketch.points[0], sketch.points[1]);
  if (feature < 0) return;
  model_.held = Handle{other(sketch.side), feature, 1, -1};
  tell_of_new();
}

void Gestures::end_band() {
  const Sketch sketch = *std::exchange(model_.sketch, std::nullopt);
  const cv::Rect2d band(sketch.points[0], sketch.points[1]);
  const auto inside = [&](cv::Point2d at) {
    return at.x >= band.x && at.y >= band.y && at.x <= band.br().x && at.y <= band.br().y;
  };
  const Document& document = model_.document;
  Selection found;
  if (model_.tool == Tool::kMesh) {
    const std::vector<cv::Point2d> vertices = document.mesh_vertices(sketch.side);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (inside(vertices[i])) found.vertices.push_back(static_cast<int>(i));
  } else {
    const auto& features = document.project().features;
    for (std::size_t i = 0; i < features.size(); ++i)
      if (std::ranges::any_of(outline_of(features[i], sketch.side), inside))
        found.features.push_back(static_cast<int>(i));
  }
  if (adding_) {
    found.features = united(std::move(found.features), document.selection().features);
    found.vertices = united(std::move(found.vertices), document.selection().vertices);
  }
  select(std::move(found));
}

void Gestures::wheel(const Mouse& mouse) {
  const std::optional<Pane> pane = layout_.pane_at(mouse.position);
  if (!pane || model_.question || model_.help) return;
  const cv::Rect& rect = layout_.pane(*pane);
  model_.view(*pane) =
      zoomed(model_.view(*pane), std::pow(kZoomPerNotch, mouse.notches), mouse.position - rect.tl(), rect.size());
  follow_view(*pane);
}

void Gestures::pan(cv::Point position) {
  View& view = model_.view(pane_);
  view.centre += last_ - content_at(position);
  // Far enough that the picture leaves the pane, and no farther.
  const cv::Size size = model_.content_size(pane_);
  view.centre.x = std::clamp(view.centre.x, 0.0, static_cast<double>(size.width));
  view.centre.y = std::clamp(view.centre.y, 0.0, static_cast<double>(size.height));
  last_ = content_at(position);
  follow_view(pane_);
}

void Gestures::follow_view(Pane pane) {
  if (!model_.switches.locked || pane == Pane::kResult) return;
  const Pane partner = pane == Pane::kSource ? Pane::kDestination : Pane::kSource;
  model_.view(partner) = matching(model_.view(pane), model_.content_size(pane), model_.content_size(partner));
}

void Gestures::slide(cv::Point position) {
  const cv::Rect track = slider_track(slider_, layout_.scale);
  const double knob = std::clamp(static_cast<double>(position.x - track.x) / track.width, 0.0, 1.0);
  if (slider_.action == Action::kTime) {
    model_.playing = false;
    model_.t = knob;
  } else {
    model_.document.tune(static_cast<Tuning>(slider_.value), tuning_from_slider(slider_.value, knob));
  }
}

void Gestures::drop() {
  drag_ = Drag::kNothing;
  model_.sketch.reset();
  model_.snapped.reset();
  model_.held.reset();
  if (model_.document.in_step()) model_.document.cancel();
}

void Gestures::begin_step() {
  if (!model_.document.in_step()) model_.document.begin();
}

void Gestures::end_step() {
  if (model_.document.in_step()) model_.document.end();
}

void Gestures::select(Selection selection) {
  model_.held.reset();
  model_.document.select(std::move(selection));
}

cv::Point2d Gestures::content_at(cv::Point position) const {
  return to_content(model_, layout_, pane_, position);
}

cv::Point2d Gestures::snapped(cv::Point2d position, const Mouse& mouse, int except) {
  model_.snapped.reset();
  const SideIndex side = side_of(pane_);
  const double zoom = model_.view(pane_).zoom;
  if (!model_.switches.snap || mouse.alt) return rounded(position, zoom);
  const double px = layout_.scale / zoom;
  model_.snapped = nearest_end(model_.document, side, position, kEndReach * px, except);
  if (model_.snapped) return *model_.snapped;  // to the bit: ends that meet stay together
  model_.snapped = edges_(side, position, kEdgeReach * px, zoom);
  return rounded(model_.snapped.value_or(position), zoom);
}

SideIndex Gestures::side_at_hand() const {
  const std::optional<Pane> pane = layout_.pane_at(model_.mouse);
  if (pane && *pane != Pane::kResult) return side_of(*pane);
  return model_.held ? model_.held->side : side_;
}

void Gestures::tick(double seconds) {
  if (!model_.playing) return;
  const project::Output& output = model_.document.project().output;
  const double length_s = std::max(1, output.frames - 1) * static_cast<double>(output.fps.den) / output.fps.num;
  double t = model_.t + direction_ * seconds * model_.speed / length_s;
  if (t > 1) direction_ = -1;
  if (t < 0) direction_ = 1;
  // Reflected at both ends, as often as it takes.
  t = std::fmod(std::abs(t), 2.0);
  if (t > 1) t = 2 - t;
  model_.t = t;
}

}  // namespace morphkit::edit
