#pragma once
// The only door to oneTBB: threads to compute with, parallel rows and a bounded frame pipeline.

#include <cstdint>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace morphkit {

namespace detail {
class Arena;
}

/// Threads to compute with. A handle: copies are the same threads. What runs inside `run` computes with them; what runs
/// outside of any computes with those that oneTBB gives to the calling thread, so that a library in another program is
/// a guest. Results never depend on it.
class Workers {
 public:
  /// @param threads  0: as many as the machine has. @throws std::invalid_argument if negative.
  explicit Workers(int threads = 0);

  /// Those that the calling thread computes with: for a thread that it starts.
  static Workers current();

  /// Calls `fn()` on the calling thread, which computes with these workers meanwhile and holds none of them while it
  /// waits for something else.
  template <typename Fn>
  decltype(auto) run(const Fn& fn) const {
    const Scope scope(*this);
    return fn();
  }

  /// As `run`, until the end of a block of the calling thread.
  class Scope {
   public:
    explicit Scope(const Workers& workers);
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();

   private:
    std::shared_ptr<detail::Arena> outer_;
  };

 private:
  explicit Workers(std::shared_ptr<detail::Arena> arena) : arena_(std::move(arena)) {}
  std::shared_ptr<detail::Arena> arena_;  ///< null: those that oneTBB gives
};

/// The number of threads that the calling thread computes with, at least 1.
int threads();

/// For a program, never for a library: bounds the threads that oneTBB starts in this process, whoever asks, and allows
/// more than the machine has.
class ProcessThreads {
 public:
  explicit ProcessThreads(int threads);
  ~ProcessThreads();
  ProcessThreads(const ProcessThreads&) = delete;
  ProcessThreads& operator=(const ProcessThreads&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

namespace detail {
using RowsFunction = void (*)(const void* context, int begin, int end);
void run_rows(int height, int grain, RowsFunction function, const void* context);

struct PipelineStages {
  std::function<std::shared_ptr<void>(std::int64_t index)> make;
  std::function<void(std::int64_t index, void* item)> deliver;
};
std::int64_t run_pipeline(std::int64_t count, int in_flight, const PipelineStages& stages,
                          const std::function<bool()>& cancelled);
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

/// Makes items 0 .. count-1 by `make(index)`, in any order and several at once, and gives them to
/// `deliver(index, item)` one at a time and in order, with at most `in_flight` alive at once. If `in_flight` is above
/// 1, an extra thread beside the workers delivers them: it mostly waits for a disk or a pipe, and no computing thread
/// waits with it. An exception in a stage stops the pipeline. The exception of the first failing item is rethrown; all
/// items before it have been delivered. `cancelled` is called before each item, on one thread at a time (empty: never).
/// If it returns true, the run ends early: items already begun are still delivered.
/// @return  number of items delivered.
/// Up to in_flight - made_at_once(in_flight) items wait for delivery while others are made.
/// @throws std::invalid_argument if in_flight is below 1.
template <typename Make, typename Deliver>
std::int64_t run_pipeline(std::int64_t count, int in_flight, const Make& make, const Deliver& deliver,
                          const std::function<bool()>& cancelled = {}) {
  using Item = std::invoke_result_t<const Make&, std::int64_t>;
  const detail::PipelineStages stages{
      [&](std::int64_t index) -> std::shared_ptr<void> { return std::make_shared<Item>(make(index)); },
      [&](std::int64_t index, void* item) { deliver(index, std::move(*static_cast<Item*>(item))); }};
  return detail::run_pipeline(count, in_flight, stages, cancelled);
}

/// How many of `in_flight` items can be made at once; the others wait for delivery.
constexpr int made_at_once(int in_flight) {
  if (in_flight < 2) return in_flight;
  return in_flight - (in_flight < 4 ? 1 : 2);
}

}  // namespace morphkit
