#include "cli/terminal.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit::cli {
namespace {

constexpr double kRedrawInterval_s = 0.1;
constexpr double kLineInterval_s = 30;

double seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

int terminal_columns(std::FILE* file) {
  struct winsize size = {};
  if (ioctl(fileno(file), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

std::string duration_text(double duration_s) {
  const long long whole = std::llround(duration_s);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

[[noreturn]] void fail_write(int error) {
  throw Error(ErrorKind::kIo, "standard output", fmt::format("cannot write: {}", std::strerror(error)));
}

}  // namespace

void Output::print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), results_) != text.size()) fail_write(errno);
}

void Output::line(std::string_view text) {
  print(text);
  print("\n");
}

void Output::flush() {
  if (std::fflush(results_) != 0) fail_write(errno);
}

void Output::message(std::string_view text) {
  // If standard error is closed, nobody can be told; the exit code remains.
  if (bar_drawn_) fmt::print(messages_, "\n");
  bar_drawn_ = false;
  std::fwrite(text.data(), 1, text.size(), messages_);
  std::fputc('\n', messages_);
}

void Output::error(std::string_view text) {
  message(fmt::format("morphkit: error: {}", text));
}

void Output::warning(std::string_view text) {
  message(fmt::format("morphkit: warning: {}", text));
}

void Output::note(std::string_view text) {
  if (verbosity_ != Verbosity::kQuiet) message(text);
}

void Output::detail(std::string_view text) {
  if (verbosity_ == Verbosity::kVerbose) message(text);
}

bool Output::interactive() const {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return !dumb && isatty(fileno(messages_)) == 1;
}

std::string progress_text(const ProgressState& state, std::string_view unit) {
  std::string text = fmt::format("{}/{} {}", state.done + state.skipped, state.total, unit);
  if (state.skipped > 0) text += fmt::format(" ({} already there)", state.skipped);
  if (state.done == 0 || state.elapsed_s <= 0) return text;
  const double rate = state.done / state.elapsed_s;
  const int left = state.total - state.done - state.skipped;
  text += fmt::format(", {:.{}f} {}/s", rate, rate < 100 ? 1 : 0, unit);
  text += left > 0 ? fmt::format(", {} left", duration_text(left / rate))
                   : fmt::format(", {}", duration_text(state.elapsed_s));
  return text;
}

ProgressBar::ProgressBar(Output& output, std::string unit)
    : output_(output),
      unit_(std::move(unit)),
      interactive_(output.interactive()),
      start_(Clock::now()),
      last_shown_(start_ - std::chrono::hours(1)) {}

ProgressBar::~ProgressBar() {
  if (!output_.bar_drawn_) return;
  std::fputc('\n', output_.messages_);
  output_.bar_drawn_ = false;
}

void ProgressBar::update(int done, int skipped, int total) {
  if (output_.verbosity() == Verbosity::kQuiet || total <= 0) return;
  const Clock::time_point now = Clock::now();
  const ProgressState state{done, skipped, total, seconds(now - start_)};
  const double since_last_s = seconds(now - last_shown_);
  if (interactive_) {
    if (since_last_s < kRedrawInterval_s && done + skipped < total) return;
    redraw(state);
  } else {
    report(state, since_last_s);
  }
}

void ProgressBar::redraw(const ProgressState& state) {
  const std::string text = progress_text(state, unit_);
  const int columns = terminal_columns(output_.messages_);
  const int width = std::clamp(columns - static_cast<int>(text.size()) - 4, 0, 40);
  const double fraction = std::min(1.0, static_cast<double>(state.done + state.skipped) / state.total);
  const int filled = static_cast<int>(width * fraction);
  const std::string bar = width < 5 ? "" : fmt::format("[{:#<{}}{:<{}}] ", "", filled, "", width - filled);
  fmt::print(output_.messages_, "\r\x1b[K{}{}", bar,
             text.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0))));
  std::fflush(output_.messages_);
  output_.bar_drawn_ = true;
  last_shown_ = Clock::now();
}

void ProgressBar::report(const ProgressState& state, double since_last_s) {
  const auto tenths = static_cast<int>(10LL * (state.done + state.skipped) / state.total);
  if (tenths == tenths_shown_ && since_last_s < kLineInterval_s) return;
  tenths_shown_ = tenths;
  last_shown_ = Clock::now();
  output_.message(progress_text(state, unit_));
  std::fflush(output_.messages_);
}

}  // namespace morphkit::cli
