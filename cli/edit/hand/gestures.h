#pragma once
// What the hand does: mouse and keys to changes of the model.

#include <functional>
#include <optional>
#include <span>
#include <string>

#include <opencv2/core.hpp>

#include "cli/edit/view/model.h"

namespace morphkit::edit {

struct Mouse {
  enum class What { kMove, kPress, kRelease, kDoubleClick, kWheel };
  enum class Button { kNone, kLeft, kMiddle, kRight };
  What what = What::kMove;
  Button button = Button::kNone;
  cv::Point position;  ///< canvas px; may lie outside
  bool shift = false, ctrl = false, alt = false;
  double notches = 0;  ///< wheel; positive: away from the hand, which zooms in
};

/// Keys as highgui's waitKeyEx delivers them: letters in lower case, and these.
enum Key : int {
  kKeyBackspace = 8,
  kKeyTab = 9,
  kKeyEnter = 13,
  kKeyEscape = 27,
  kKeySpace = 32,
  kKeyHome = 65360,
  kKeyEnd = 65367,
  kKeyF1 = 65470,
  kKeyShift = 65505,
  kKeyDelete = 65535
};

/// What only the surroundings can do.
enum class Wish { kSave, kClose };

/// Where to snap on a picture: the strongest edge within `radius` px of a position of its side, or nothing.
/// @param zoom  at which the picture is looked at.
using EdgeFinder =
    std::function<std::optional<cv::Point2d>(SideIndex side, cv::Point2d position, double radius, double zoom)>;

/// How near ends and edges must be to be snapped to, in units of Layout::scale.
inline constexpr double kEndReach = 8;
inline constexpr double kEdgeReach = 6;

/// Turns input into changes of a model. Holds what lasts from press to release. The model outlives it.
class Gestures {
 public:
  Gestures(Model& model, EdgeFinder edges);

  std::optional<Wish> mouse(const Mouse& mouse);
  std::optional<Wish> key(int key);
  /// Time passes: what plays goes on, forth and back, at the project's rate times `speed`.
  void tick(double seconds);

 private:
  /// What the mouse is dragging.
  enum class Drag { kNothing, kPoint, kFeatures, kVertices, kLine, kBand, kPan, kSlider };

  friend struct KeyRow;

  // Mouse
  std::optional<Wish> press(const Mouse& mouse, bool again);
  std::optional<Wish> press_widget(const Widget& widget, cv::Point position);
  void press_picture(const Mouse& mouse, bool again);
  void press_handle(const Handle& handle, const Mouse& mouse);
  void press_blank(const Mouse& mouse);
  void press_curve(const Mouse& mouse, bool again);
  void drag_to(const Mouse& mouse);
  void drag_held(const Mouse& mouse, cv::Point2d by);  ///< `by`: since the press, px of the picture
  void release(const Mouse& mouse);
  void select_alone();  ///< what is held: a click on one of several
  void end_line(cv::Point position);
  void end_band();
  void wheel(const Mouse& mouse);
  void slide(cv::Point position);
  void pan(cv::Point position);
  void drop();  ///< what is being dragged, as if it had never been

  // Keys
  std::optional<Wish> press_key(int key);
  bool leave();  ///< Esc: what is going on ends. false: nothing was
  void nudge(int key);
  void step_frames(int frames);

  // What is typed
  void type(int key);
  void begin_entry(Entry::What what);
  void accept_entry();
  void answer(int key);

  // Widgets and keys
  std::optional<Wish> act(Action action, int value = 0);
  void choose_tool(Tool tool);
  void end_curve(bool closed);
  void tell_of_new();      ///< the last feature
  void take_back_click();  ///< the last one of a curve. @pre sketches_curve()
  void erase();
  void undo(bool back);
  void select_all();  ///< vertices with the mesh tool, features with the others
  void select_next();
  void next_easing(Progress which);
  void add_to_mesh(bool column);         ///< at the mouse
  void add_to_largest_gap(bool column);  ///< halves it
  void remove_from_mesh(bool column);

  // All
  bool sketches_curve() const;
  void follow_view(Pane pane);
  void begin_step();
  void end_step();
  void say(std::string text) { model_.message = std::move(text); }
  void select(Selection selection);
  cv::Point2d content_at(cv::Point position) const;  ///< of `pane_`
  cv::Point2d snapped(cv::Point2d position, const Mouse& mouse, int except);
  SideIndex side_at_hand() const;  ///< under the mouse, else where something is held, else of the last press

  Model& model_;
  EdgeFinder edges_;
  Layout layout_;  ///< at the last event
  Drag drag_ = Drag::kNothing;
  Pane pane_ = Pane::kSource;  ///< where the press was
  SideIndex side_ = kSource;   ///< where the last press on a picture was
  cv::Point pressed_;          ///< canvas px
  cv::Point2d last_;           ///< content px up to which the drag has been followed
  cv::Point2d began_;          ///< content px of the press
  cv::Point2d from_;           ///< where the point that is held was at the press, px of the picture
  Widget slider_;
  bool dragged_ = false;  ///< the mouse has gone further since the press than a click may
  bool adding_ = false;   ///< a rubber band adds to the selection
  bool capital_ = false;  ///< Shift came before the next letter of an entry
  double direction_ = 1;  ///< of playing
};

}  // namespace morphkit::edit
