#include "cli/edit/window.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>
#include <opencv2/highgui.hpp>

#include "cli/edit/hand/editor.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"

namespace morphkit::edit {
namespace {

constexpr const char* kWindow = "morphkit edit";
constexpr int kBusyWaitMs = 1;     ///< while events come: fetch them at once
constexpr int kPlayingWaitMs = 8;  ///< faster than any screen refreshes
constexpr int kIdleWaitMs = 15;    ///< no events: leave the CPU idle

constexpr const char* kNoDisplay = "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set)";

/// Qt ends the process where it finds no display behind DISPLAY. Tells the person, with the exit code of failed work.
extern "C" void on_abort(int) {
  static const char text[] = "morphkit: error: edit: no window could be opened on this display\n";
  const ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);
  _exit(written < 0 ? 1 : cli::kExitFailed);
}

Mouse::Button button_of(int event) {
  switch (event) {
    case cv::EVENT_LBUTTONDOWN:
    case cv::EVENT_LBUTTONUP:
    case cv::EVENT_LBUTTONDBLCLK:
      return Mouse::Button::kLeft;
    case cv::EVENT_MBUTTONDOWN:
    case cv::EVENT_MBUTTONUP:
    case cv::EVENT_MBUTTONDBLCLK:
      return Mouse::Button::kMiddle;
    case cv::EVENT_RBUTTONDOWN:
    case cv::EVENT_RBUTTONUP:
    case cv::EVENT_RBUTTONDBLCLK:
      return Mouse::Button::kRight;
    default:
      return Mouse::Button::kNone;
  }
}

Mouse::What what_of(int event) {
  switch (event) {
    case cv::EVENT_LBUTTONDOWN:
    case cv::EVENT_MBUTTONDOWN:
    case cv::EVENT_RBUTTONDOWN:
      return Mouse::What::kPress;
    case cv::EVENT_LBUTTONUP:
    case cv::EVENT_MBUTTONUP:
    case cv::EVENT_RBUTTONUP:
      return Mouse::What::kRelease;
    case cv::EVENT_LBUTTONDBLCLK:
    case cv::EVENT_MBUTTONDBLCLK:
    case cv::EVENT_RBUTTONDBLCLK:
      return Mouse::What::kDoubleClick;
    case cv::EVENT_MOUSEWHEEL:
      return Mouse::What::kWheel;
    default:
      return Mouse::What::kMove;
  }
}

/// highgui's events, kept until the loop takes them.
class EventQueue {
 public:
  void add(int event, int x, int y, int flags) {
    Mouse mouse;
    mouse.what = what_of(event);
    mouse.button = button_of(event);
    mouse.position = {x, y};
    mouse.shift = (flags & cv::EVENT_FLAG_SHIFTKEY) != 0;
    mouse.ctrl = (flags & cv::EVENT_FLAG_CTRLKEY) != 0;
    mouse.alt = (flags & cv::EVENT_FLAG_ALTKEY) != 0;
    if (mouse.what == Mouse::What::kWheel) {
      mouse.notches = cv::getMouseWheelDelta(flags) / 120.0;
      // The Qt window zooms a view of its own at every turn of the wheel; `restore_view` goes back to before the first.
      if (!wheel_turned_) cv::saveWindowParameters(kWindow);
      wheel_turned_ = true;
    }
    // Of moves in a row only the last one matters.
    const bool follows_move = !events_.empty() && events_.back().what == Mouse::What::kMove;
    if (mouse.what == Mouse::What::kMove && follows_move) {
      events_.back() = mouse;
    } else {
      events_.push_back(mouse);
    }
  }

  std::vector<Mouse> take() { return std::exchange(events_, {}); }
  bool take_wheel_turned() { return std::exchange(wheel_turned_, false); }

 private:
  std::vector<Mouse> events_;
  bool wheel_turned_ = false;
};

void open_window(EventQueue& queue) {
  // Other flags would give it a tool bar with shortcuts and dialogs of its own.
  cv::namedWindow(kWindow, cv::WINDOW_AUTOSIZE | cv::WINDOW_GUI_NORMAL);
  cv::setMouseCallback(
      kWindow,
      [](int event, int x, int y, int flags, void* user) { static_cast<EventQueue*>(user)->add(event, x, y, flags); },
      &queue);
}

/// Brings the Qt window back to showing the canvas as it is. It forgets its own zoom only with a picture of another
/// size.
/// @return the key that was pressed meanwhile, or -1.
int restore_view(const cv::Mat3b& canvas) {
  cv::loadWindowParameters(kWindow);
  cv::Mat3b taller;
  cv::copyMakeBorder(canvas, taller, 0, 1, 0, 0, cv::BORDER_REPLICATE);
  cv::imshow(kWindow, taller);
  const int key = cv::waitKeyEx(1);
  cv::imshow(kWindow, canvas);
  return key;
}

/// Detects that the user has closed the window. A new window takes a while to appear.
class Watch {
 public:
  bool closed() {
    const bool visible = cv::getWindowProperty(kWindow, cv::WND_PROP_VISIBLE) >= 1;
    appeared_ = appeared_ || visible;
    return appeared_ && !visible;
  }
  void restart() { appeared_ = false; }

 private:
  bool appeared_ = false;
};

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void show(Editor& editor, std::string& title) {
  cv::imshow(kWindow, editor.draw());
  if (editor.title() == title) return;
  title = editor.title();
  cv::setWindowTitle(kWindow, title);
}

/// highgui gives the last key that came while it looked at events, and forgets others.
/// @return whether there were events.
bool take_events(Editor& editor, EventQueue& queue, int key) {
  const std::vector<Mouse> events = queue.take();
  for (const Mouse& event : events) editor.mouse(event);
  if (key != -1) editor.key(key);
  return !events.empty() || key != -1;
}

void run_events(Editor& editor, EventQueue& queue) {
  Watch watch;
  std::string title;
  editor.turn(seconds_now());
  show(editor, title);
  bool busy = true;
  while (!editor.done()) {
    const bool playing = editor.model().playing;
    const int key = cv::waitKeyEx(playing ? kPlayingWaitMs : busy ? kBusyWaitMs : kIdleWaitMs);
    if (cli::interrupted()) {
      throw Error(ErrorKind::kInterrupted, "edit", fmt::format("interrupted; {}", editor.rescue()));
    }
    busy = take_events(editor, queue, key);
    if (watch.closed() && !editor.done()) {
      editor.close();
      if (!editor.done()) {  // it asks a question, so the window must return
        open_window(queue);
        watch.restart();
        title.clear();
      }
    }
    editor.turn(seconds_now());
    if (editor.done()) break;
    if (queue.take_wheel_turned()) take_events(editor, queue, restore_view(editor.draw()));
    if (editor.dirty()) {
      show(editor, title);
      busy = true;
    }
  }
}

}  // namespace

void require_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return;
  }
  throw Error(ErrorKind::kFailed, "edit", kNoDisplay);
}

void run_window(Editor& editor) {
  require_display();
  EventQueue queue;
  const auto before = std::signal(SIGABRT, on_abort);
  open_window(queue);
  std::signal(SIGABRT, before);
  try {
    run_events(editor, queue);
  } catch (...) {
    editor.rescue();
    throw;
  }
  cv::destroyAllWindows();
}

}  // namespace morphkit::edit
