#pragma once
// A question that long work asks from time to time: whether it is to be given up.

#include <functional>

namespace morphkit {

/// Returns true if work is to be given up. Thread-safe; empty: never.
using StopQuestion = std::function<bool()>;

/// Until the end of a block, the work of the calling thread asks `question`: for_rows before each band, whatever
/// threads compute it, and encoders of pictures. Outside of any scope nothing is asked.
class StopScope {
 public:
  explicit StopScope(StopQuestion question);
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;
  ~StopScope();

 private:
  StopQuestion outer_;
};

/// That of the calling thread: for a thread that it starts.
const StopQuestion& stop_question() noexcept;

/// @throws Error kInterrupted if the answer is yes.
void stop_if_asked(const StopQuestion& question = stop_question());

}  // namespace morphkit
