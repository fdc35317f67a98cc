#pragma once
// The number of threads of a test or a benchmark.

#include <optional>

#include <opencv2/core/utility.hpp>

#include "base/parallel.h"

namespace morphkit::test {

/// From here on the calling thread, and OpenCV, compute with this many threads, also if the machine has fewer; 0: all
/// that it has. For one thread of the process.
inline void set_threads(int threads) {
  static std::optional<ProcessThreads> allowed;
  // Never destroyed: what it restores belongs to the thread, which ends before static objects do.
  static auto& scope = *new std::optional<Workers::Scope>;
  // The old bound goes first: while two exist oneTBB obeys the smaller one.
  scope.reset();
  allowed.reset();
  if (threads > 0) allowed.emplace(threads);
  scope.emplace(Workers(threads));
  cv::setNumThreads(threads > 0 ? threads : -1);
}

}  // namespace morphkit::test
