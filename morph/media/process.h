#pragma once
// A child program that reads our data on its standard input. Internal to morph/media.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/descriptor.h"

namespace morphkit::media {

/// A program started from an argument vector (never through a shell), with a pipe to its standard input. Its standard
/// output is discarded, and the end of its standard error is kept.
///
/// It runs in a process group of its own: Ctrl-C reaches only us, and we decide when it ends. Not copyable; for one
/// thread at a time. The destructor kills and reaps a running program and everything it started.
class Process {
 public:
  /// How a program ended.
  struct Exit {
    int status = 0;  ///< exit status, or -1 if a signal ended it
    int signal = 0;  ///< the signal, or 0
    bool ok() const { return status == 0 && signal == 0; }
    /// "ended with status 3", "was ended by signal 9 (Killed)".
    std::string text() const;
  };

  /// @param arguments  the program (looked up on PATH) and its arguments, at least one.
  /// @throws std::system_error if it cannot be started: ENOENT when it is not on PATH.
  explicit Process(const std::vector<std::string>& arguments);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// Writes all bytes, waiting while the pipe is full. SIGPIPE is never raised.
  /// @return  false if the program has closed its input, usually because it has ended.
  /// @throws std::system_error for any other failure.
  bool write(std::span<const std::uint8_t> bytes);

  /// Closes its standard input and waits until it ends. Programs that it started and left behind are killed. Afterwards
  /// last_lines() is complete. Repeated calls return the same.
  Exit finish();

  /// Kills and reaps the program and everything it started. Does nothing if it has ended.
  void kill() noexcept;

  /// The end of its standard error, at most 4 KiB, whole lines. Call it after finish().
  std::string last_lines() const;

 private:
  class Drain;

  void reap() noexcept;

  pid_t pid_ = -1;    ///< -1 once reaped
  Descriptor input_;  ///< our end of the pipe
  Exit exit_;
  std::unique_ptr<Drain> drain_;
};

}  // namespace morphkit::media
