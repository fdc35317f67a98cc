#pragma once
// Previews are rendered in a thread, so the event loop never waits.

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "cli/edit/view/preview.h"

namespace morphkit::edit {

/// The newest request wins: a waiting request is replaced, a running one is abandoned. If a picture takes long, a draft
/// comes first.
class PreviewThread {
 public:
  /// The pyramids outlive it.
  PreviewThread(const Pyramid& source, const Pyramid& destination, const Pyramid* background = nullptr);
  ~PreviewThread();
  PreviewThread(const PreviewThread&) = delete;
  PreviewThread& operator=(const PreviewThread&) = delete;

  void request(PreviewRequest request);

  /// The newest picture finished since the last call. Numbers never decrease.
  std::optional<PreviewPicture> take();

  /// Waits until the last request has its picture.
  void finish();

 private:
  void work();
  void deliver(PreviewPicture picture);
  bool out_of_date();

  PreviewRenderer renderer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PreviewRequest> wanted_;
  std::optional<PreviewPicture> finished_;
  bool busy_ = false;
  bool stopping_ = false;
  double last_milliseconds_ = 0;  ///< of the last picture that was no draft
  std::thread thread_;            ///< last: it uses the others
};

/// Above this, ms, a draft comes first.
inline constexpr double kDraftAbove = 25;
inline constexpr int kDraftReduction = 3;

}  // namespace morphkit::edit
