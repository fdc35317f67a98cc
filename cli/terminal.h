#pragma once
// What the person or the script at the other end sees: results on standard output; warnings, notes and progress on
// standard error.

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace morphkit::cli {

/// How much is said besides results, warnings and errors.
enum class Verbosity { kQuiet, kNormal, kVerbose };

class Output {
 public:
  Output(std::FILE* results, std::FILE* messages, Verbosity verbosity)
      : results_(results), messages_(messages), verbosity_(verbosity) {}

  Verbosity verbosity() const noexcept { return verbosity_; }
  void set_verbosity(Verbosity verbosity) noexcept { verbosity_ = verbosity; }

  /// A result, as it is. @throws Error kIo if it cannot be written.
  void print(std::string_view text);
  /// A result and a newline.
  void line(std::string_view text);
  /// Brings out what `print` holds back. @throws Error kIo.
  void flush();

  void error(std::string_view text);    ///< "morphkit: error: text"
  void warning(std::string_view text);  ///< "morphkit: warning: text"; kQuiet does not silence it
  void note(std::string_view text);     ///< what is good to know; not with kQuiet
  void detail(std::string_view text);   ///< only with kVerbose

  /// Whether messages go to a terminal that can redraw a line.
  bool interactive() const;

 private:
  friend class ProgressBar;
  void message(std::string_view text);

  std::FILE* results_;
  std::FILE* messages_;
  Verbosity verbosity_;
  bool bar_drawn_ = false;  ///< the cursor stands in a progress bar's line
};

/// State of a long job, for progress_text.
struct ProgressState {
  int done = 0;     ///< items finished in this run
  int skipped = 0;  ///< items that needed no work
  int total = 0;    ///< items asked for
  double elapsed_s = 0;
};

/// "120/240 frames, 48.1 frames/s, 3 s left": rate and time left are of the items that needed work, and missing until
/// there are any.
std::string progress_text(const ProgressState& state, std::string_view unit);

/// Tells how a long job goes: a bar that is redrawn on a terminal, else a line at every tenth of the job (and once in
/// half a minute), nothing with kQuiet.
class ProgressBar {
 public:
  /// @param unit  what is counted, in the plural: "frames".
  ProgressBar(Output& output, std::string unit);
  /// Ends the bar's line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Call after each item, from one thread at a time.
  void update(int done, int skipped, int total);

 private:
  using Clock = std::chrono::steady_clock;
  void redraw(const ProgressState& state);
  void report(const ProgressState& state, double since_last_s);

  Output& output_;
  std::string unit_;
  bool interactive_;
  Clock::time_point start_;
  Clock::time_point last_shown_;
  int tenths_shown_ = -1;
};

}  // namespace morphkit::cli
