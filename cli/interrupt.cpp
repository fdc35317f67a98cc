#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

#include <signal.h>

#include "base/error.h"

namespace morphkit::cli {
namespace {

/// The time of the first signal, ns of the monotonic clock; 0: none yet.
std::atomic<std::int64_t> first_signal_ns{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may only use lock-free atomics");

/// `timeout` signals the process and then its group; that is one request.
constexpr std::int64_t kOneRequestNs = 500'000'000;

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void on_interrupt(int signal_number) {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now_ns = std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  std::int64_t first_ns = 0;
  if (first_signal_ns.compare_exchange_strong(first_ns, now_ns) || now_ns - first_ns < kOneRequestNs) return;
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);  // arrives when this handler returns
}

}  // namespace

void install_interrupt_handlers() {
  for (const int signal_number : kSignals) {
    struct sigaction action = {};
    sigaction(signal_number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = on_interrupt;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
  }
}

bool interrupted() noexcept {
  return first_signal_ns.load() != 0;
}

void stop_if_interrupted(const std::string& what) {
  if (interrupted()) throw Error(ErrorKind::kInterrupted, "", "interrupted; " + what);
}

}  // namespace morphkit::cli
