#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

#include <signal.h>

#include "morph/error.h"

namespace morphkit::cli {
namespace {

std::atomic<bool> interrupt_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only use lock-free atomics");

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void on_interrupt(int) {
  interrupt_flag.store(true);
  for (const int signal_number : kSignals) std::signal(signal_number, SIG_DFL);
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
  return interrupt_flag.load();
}

void stop_if_interrupted(const std::string& what) {
  if (interrupted()) throw Error(ErrorCode::kInterrupted, "", "interrupted; " + what);
}

}  // namespace morphkit::cli
