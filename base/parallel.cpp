#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "base/stop.h"

namespace morphkit {

class detail::Arena {
 public:
  explicit Arena(int threads) : threads_(threads), arena_(threads) {}
  int threads() const { return threads_; }
  tbb::task_arena& arena() { return arena_; }

 private:
  int threads_;
  tbb::task_arena arena_;
};

struct ProcessThreads::Control {
  explicit Control(int threads)
      : bound(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
  tbb::global_control bound;
};

namespace {

using detail::Arena;
using detail::PipelineStages;

/// Of the Scope that this thread is in. Null in a thread of oneTBB, which is in its arena already.
thread_local std::shared_ptr<Arena> current_arena;

template <typename Fn>
void in_arena(const Fn& fn) {
  if (const std::shared_ptr<Arena> arena = current_arena)
    arena->arena().execute(fn);
  else
    fn();
}

/// One item between the stages. A failure travels in the place of its item: everything before it is delivered, and the
/// first failing item is the one reported, for any number of threads.
struct Item {
  std::int64_t index = 0;
  std::shared_ptr<void> value;
  std::exception_ptr failure;
};

/// A thread that delivers items one after the other. Holds at most `capacity` items, including the one being delivered.
class Delivery {
 public:
  Delivery(int capacity, std::function<void(const Item&)> deliver)
      : capacity_(static_cast<std::size_t>(capacity)),
        deliver_(std::move(deliver)),
        thread_([this, workers = Workers::current()] { workers.run([this] { run(); }); }) {}
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;
  ~Delivery() { finish(); }

  /// Waits until there is room.
  void push(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return items_.size() < capacity_; });
    items_.push_back(std::move(item));
    changed_.notify_all();
  }

  /// Returns when everything has been delivered.
  void finish() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return closed_ || !items_.empty(); });
      if (items_.empty()) return;
      Item& item = items_.front();  // new items go behind it
      lock.unlock();
      deliver_(item);
      item = {};
      lock.lock();
      items_.pop_front();
      changed_.notify_all();
    }
  }

  const std::size_t capacity_;
  const std::function<void(const Item&)> deliver_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> items_;
  bool closed_ = false;
  std::thread thread_;  ///< last member: it uses the others
};

/// One run of the frame pipeline. No exception ever reaches oneTBB: its cancellation would cut short the rows of items
/// that are still being made.
class PipelineRun {
 public:
  PipelineRun(std::int64_t count, const PipelineStages& stages, const std::function<bool()>& cancelled)
      : count_(count), stages_(stages), cancelled_(cancelled) {}

  std::int64_t run(int in_flight) {
    const int making = made_at_once(in_flight);
    std::optional<Delivery> delivery;
    if (making < in_flight) delivery.emplace(in_flight - making, [this](const Item& item) { deliver(item); });
    in_arena([&] {
      tbb::parallel_pipeline(
          static_cast<std::size_t>(making),
          tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order, [this](tbb::flow_control& flow) {
            return next(flow);
          }) & tbb::make_filter<std::int64_t, Item>(tbb::filter_mode::parallel, [this](std::int64_t index) {
            return make(index);
          }) & tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, [&](Item item) {
            if (delivery)
              delivery->push(std::move(item));
            else
              deliver(item);
          }));
    });
    if (delivery) delivery->finish();
    if (failure_) std::rethrow_exception(failure_);
    if (cancel_failure_) std::rethrow_exception(cancel_failure_);
    return delivered_;
  }

 private:
  std::int64_t next(tbb::flow_control& flow) {
    if (next_ < count_ && !stopped_ && !ask_cancelled()) return next_++;
    flow.stop();
    return 0;
  }

  bool ask_cancelled() {
    if (!cancelled_) return false;
    try {
      return cancelled_();
    } catch (...) {
      cancel_failure_ = std::current_exception();
      return true;
    }
  }

  Item make(std::int64_t index) {
    Item item{index, nullptr, nullptr};
    if (stopped_) return item;  // no longer needed
    try {
      item.value = stages_.make(index);
    } catch (...) {
      item.failure = std::current_exception();
    }
    return item;
  }

  void deliver(const Item& item) {
    if (failure_) return;
    try {
      if (item.failure) std::rethrow_exception(item.failure);
      stages_.deliver(item.index, item.value.get());
      ++delivered_;
    } catch (...) {
      failure_ = std::current_exception();
      stopped_ = true;
    }
  }

  const std::int64_t count_;
  const PipelineStages& stages_;
  const std::function<bool()>& cancelled_;
  std::atomic<bool> stopped_ = false;
  std::int64_t next_ = 0;  ///< used by the serial first stage only
  std::exception_ptr cancel_failure_;
  std::int64_t delivered_ = 0;  ///< used by the delivering thread only, as is failure_
  std::exception_ptr failure_;
};

}  // namespace

Workers::Workers(int threads) {
  if (threads < 0) throw std::invalid_argument("Workers: " + std::to_string(threads) + " threads; 0 means all");
  arena_ = std::make_shared<Arena>(threads == 0 ? tbb::info::default_concurrency() : threads);
}

Workers Workers::current() {
  return Workers(current_arena);
}

Workers::Scope::Scope(const Workers& workers) : outer_(std::exchange(current_arena, workers.arena_)) {}

Workers::Scope::~Scope() {
  current_arena = std::move(outer_);
}

int threads() {
  return current_arena ? current_arena->threads() : tbb::this_task_arena::max_concurrency();
}

ProcessThreads::ProcessThreads(int threads) : control_(std::make_unique<Control>(threads)) {}

ProcessThreads::~ProcessThreads() = default;

void detail::run_rows(int height, int grain, RowsFunction function, const void* context) {
  if (grain < 1) throw std::invalid_argument("for_rows: grain " + std::to_string(grain) + ", must be at least 1");
  if (height <= 0) return;
  const bool one_is_left = grain > 1 && height > grain && height % grain == 1;
  const int bands = (height - 1) / grain + (one_is_left ? 0 : 1);
  const StopQuestion& question = stop_question();  // threads of oneTBB have none
  const auto run_band = [&](int band) {
    stop_if_asked(question);
    const int begin = band * grain;
    function(context, begin, band == bands - 1 ? height : begin + grain);
  };
  if (bands == 1 || threads() == 1) {
    for (int band = 0; band < bands; ++band) run_band(band);
    return;
  }
  const auto run_bands = [&](const tbb::blocked_range<int>& range) {
    for (int band = range.begin(); band < range.end(); ++band) run_band(band);
  };
  in_arena([&] {
    // Isolated twice: a thread that waits for its rows must not start another frame, and a cancelled caller must not
    // skip rows.
    tbb::this_task_arena::isolate([&] {
      tbb::task_group_context own_context(tbb::task_group_context::isolated);
      tbb::parallel_for(tbb::blocked_range<int>(0, bands, 1), run_bands, tbb::simple_partitioner(), own_context);
    });
  });
}

std::int64_t detail::run_pipeline(std::int64_t count, int in_flight, const PipelineStages& stages,
                                  const std::function<bool()>& cancelled) {
  if (in_flight < 1) {
    throw std::invalid_argument("run_pipeline: " + std::to_string(in_flight) + " in flight, must be at least 1");
  }
  if (count <= 0) return 0;
  return PipelineRun(count, stages, cancelled).run(in_flight);
}

}  // namespace morphkit
