#pragma once
// The output of the program for people and scripts: results on standard output; warnings, notes and progress on
// standard error.

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace morphkit::cli {

/// How much is printed besides results, warnings and errors.
enum class Verbosity { kQuiet, kNormal, kVerbose };

class Output {
 public:
  Output(std::FILE* results, std::FILE* messages, Verbosity verbosity)
      : results_(results), messages_(messages), verbosity_(verbosity) {}

  Verbosity verbosity() const noexcept { return verbosity_; }
  void set_verbosity(Verbosity verbosity) noexcept { verbosity_ = verbosity; }

  /// Prints a result unchanged. @throws Error kIo if it cannot be written.
  void print(std::string_view text);
  /// Prints a result and a newline.
  void line(std::string_view text);
  /// Writes everything that `print` has buffered. @throws Error kIo.
  void flush();

  void error(std::string_view text);    ///< "morphkit: error: text"
  void warning(std::string_view text);  ///< "morphkit: warning: text"; kQuiet does not silence it
  void note(std::string_view text);     ///< useful information; not with kQuiet
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
  int total = 0;    ///< requested items
  double elapsed_s = 0;
};

/// "120/240 frames, 48.1 frames/s, 3 s left": rate and time left count only items that needed work. They are missing
/// until there are such items.
std::string progress_text(const ProgressState& state, std::string_view unit);

/// Shows the progress of a long job: a bar on a terminal, else a line at every tenth of the job (and once in half a
/// minute), nothing with kQuiet.
class ProgressBar {
 public:
  /// @param unit  the counted unit in the plural: "frames".
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
