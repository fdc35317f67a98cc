#pragma once
// The only door to oneTBB: parallel rows and a bounded frame pipeline over one persistent arena.

#include <cstdint>
#include <functional>
#include <memory>

namespace morphkit {

/// Bounds the number of threads that morphkit and OpenCV use; 0 means all of the machine. Results never depend on it.
/// Call before work starts, not while it runs.
/// @throws std::invalid_argument if negative.
void set_threads(int threads);

/// The number of threads in use, at least 1.
int threads();

namespace detail {
using RowsFunction = void (*)(const void* context, int begin, int end);
void run_rows(int height, int grain, RowsFunction function, const void* context);
}  // namespace detail

/// Calls `fn(begin, end)` for consecutive bands of rows that cover [0, height). The bands depend on height and grain
/// only, never on the number of threads; a last band of a single row joins the band before it, so that every row has a
/// neighbour in its band. `fn` must be safe to call from several threads at once. An exception from `fn` skips the
/// bands that have not started and is rethrown. Calls may be nested, and the stages of run_pipeline may call it.
/// @param grain  rows per band, at least 1.
/// @throws std::invalid_argument if grain is below 1.
template <typename Fn>
void for_rows(int height, const Fn& fn, int grain = 8) {
  detail::run_rows(
      height, grain, [](const void* context, int begin, int end) { (*static_cast<const Fn*>(context))(begin, end); },
      &fn);
}

/// The two stages of the frame pipeline; see run_pipeline.
struct PipelineStages {
  std::function<std::shared_ptr<void>(std::int64_t index)> make;                       ///< any order, several at once
  std::function<void(std::int64_t index, const std::shared_ptr<void>& item)> deliver;  ///< one at a time, in order
};

/// Makes items 0 .. count-1 and delivers them in order, with at most `in_flight` alive at once. If `in_flight` is above
/// 1, an extra thread beside those of `set_threads` delivers them: it mostly waits for a disk or a pipe, and no
/// computing thread waits with it. An exception in a stage stops the pipeline. The exception of the first failing item
/// is rethrown; all items before it have been delivered. `cancelled` is called before each item, on one thread at a
/// time (empty: never). If it returns true, the run ends early: items already begun are still delivered.
/// @return  number of items delivered.
/// Up to in_flight - made_at_once(in_flight) items wait for delivery while others are made.
/// @throws std::invalid_argument if in_flight is below 1.
std::int64_t run_pipeline(std::int64_t count, int in_flight, const PipelineStages& stages,
                          const std::function<bool()>& cancelled);

/// How many of `in_flight` items can be made at once; the others wait for delivery.
constexpr int made_at_once(int in_flight) {
  if (in_flight < 2) return in_flight;
  return in_flight - (in_flight < 4 ? 1 : 2);
}

}  // namespace morphkit
