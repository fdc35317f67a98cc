#include "cli/edit/view/preview_thread.h"

#include <utility>

#include "base/parallel.h"

namespace morphkit::edit {

PreviewThread::PreviewThread(const Pyramid& source, const Pyramid& destination, const Pyramid* background)
    : renderer_(source, destination, background),
      thread_([this, workers = Workers::current()] { workers.run([this] { work(); }); }) {}

PreviewThread::~PreviewThread() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    wanted_.reset();
  }
  changed_.notify_all();
  thread_.join();
}

void PreviewThread::request(PreviewRequest request) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(request);
  }
  changed_.notify_all();
}

std::optional<PreviewPicture> PreviewThread::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(finished_, std::nullopt);
}

void PreviewThread::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !wanted_ && !busy_; });
}

bool PreviewThread::out_of_date() {
  const std::lock_guard lock(mutex_);
  return wanted_ || stopping_;
}

void PreviewThread::deliver(PreviewPicture picture) {
  const std::lock_guard lock(mutex_);
  finished_ = std::move(picture);
}

void PreviewThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return wanted_ || stopping_; });
    if (stopping_) return;
    const PreviewRequest request = *std::exchange(wanted_, std::nullopt);
    busy_ = true;
    lock.unlock();
    if (last_milliseconds_ > kDraftAbove) deliver(renderer_.render(request, kDraftReduction));
    if (!out_of_date()) {
      PreviewPicture picture = renderer_.render(request);
      last_milliseconds_ = picture.milliseconds;
      deliver(std::move(picture));
    }
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

}  // namespace morphkit::edit
