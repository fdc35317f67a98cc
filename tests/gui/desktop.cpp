#include "tests/gui/desktop.h"

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <unistd.h>

#include "tests/cli/run_program.h"

namespace morphkit::test {
namespace {

constexpr auto kPause = std::chrono::milliseconds(20);
constexpr int kPatience = 3000;  ///< pauses: a minute

std::string number(int value) {
  return std::to_string(value);
}

/// Whether the screen has an answer to this question of xdotool.
bool answers(const std::string& question) {
  return run_program(XDOTOOL, {question}).exit_code == 0;
}

}  // namespace

bool holds_at_last(const std::function<bool()>& condition) {
  for (int i = 0; i < kPatience; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(kPause);
  }
  return condition();
}

Desktop::Desktop() {
  constexpr int kFirst = 100;
  const std::string display = std::string(":").append(number(kFirst + getpid() % 30000));
  server_ = std::make_unique<media::Process>(
      std::vector<std::string>{XVFB, display, "-screen", "0", "1920x1200x24", "-nolisten", "tcp", "-noreset"});
  setenv("DISPLAY", display.c_str(), 1);
  // Its socket is there before it listens.
  if (!holds_at_last([] { return answers("getdisplaygeometry"); })) throw std::runtime_error("Xvfb does not start");
  manager_ = std::make_unique<media::Process>(std::vector<std::string>{OPENBOX});
  // It counts desktops only once it manages windows.
  if (!holds_at_last([] { return answers("get_num_desktops"); })) throw std::runtime_error("openbox does not start");
}

Desktop::~Desktop() {
  manager_.reset();
  server_.reset();
  unsetenv("DISPLAY");
}

void Desktop::xdotool(const std::vector<std::string>& words) const {
  const RunResult result = run_program(XDOTOOL, words);
  if (result.exit_code != 0) throw std::runtime_error("xdotool " + words.front() + ": " + result.err);
}

bool Desktop::has_window(const std::string& title) const {
  return run_program(XDOTOOL, {"search", "--onlyvisible", "--name", title}).exit_code == 0;
}

void Desktop::use_window(const std::string& title) {
  if (!holds_at_last([&] { return has_window(title); })) throw std::runtime_error("no window with " + title);
  const std::string found = run_program(XDOTOOL, {"search", "--onlyvisible", "--name", title}).out;
  window_ = found.substr(0, found.find('\n'));
  xdotool({"windowactivate", "--sync", window_});
}

void Desktop::move(cv::Point to) {
  xdotool({"mousemove", "--window", window_, number(to.x), number(to.y)});
}

void Desktop::drag(cv::Point from, cv::Point to) {
  move(from);
  xdotool({"mousedown", "1"});
  move((from + to) / 2);
  move(to);
  xdotool({"mouseup", "1"});
}

void Desktop::wheel(cv::Point at, int notches) {
  move(at);
  for (int i = 0; i < std::abs(notches); ++i) xdotool({"click", notches > 0 ? "4" : "5"});
}

void Desktop::press(const std::string& key) {
  xdotool({"key", "--window", window_, key});
}

void Desktop::close_window() {
  xdotool({"windowclose", window_});
}

void Desktop::screenshot(const std::filesystem::path& file) const {
  std::filesystem::create_directories(file.parent_path());
  const RunResult result = run_program(IMPORT, {"-window", "root", file.string()});
  if (result.exit_code != 0) throw std::runtime_error("import: " + result.err);
}

}  // namespace morphkit::test
