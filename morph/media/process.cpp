#include "morph/media/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX gives it no header of its own

namespace morphkit::media {
namespace {

constexpr std::size_t kKeptStderr = 4096;  // bytes

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Moves a descriptor out of 0..2. It gets such a number when our own standard streams are closed, and then the child's
/// file actions would overwrite one another.
Descriptor above_standard(Descriptor descriptor) {
  if (descriptor.get() > STDERR_FILENO) return descriptor;
  Descriptor moved(::fcntl(descriptor.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  check(moved.get() < 0 ? errno : 0, "fcntl");
  return moved;
}

struct Pipe {
  Descriptor read, write;
};

Pipe make_pipe() {
  int ends[2];
  check(::pipe2(ends, O_CLOEXEC) != 0 ? errno : 0, "pipe");
  Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
  pipe.read = above_standard(std::move(pipe.read));
  pipe.write = above_standard(std::move(pipe.write));
  return pipe;
}

/// Blocks SIGPIPE for this thread while the object exists. A pipe has no MSG_NOSIGNAL, and a library must not ignore
/// the signal for the whole process. write() raises it in the calling thread, so a pending signal is ours unless it was
/// pending before.
class SigpipeBlock {
 public:
  SigpipeBlock() {
    sigemptyset(&sigpipe_);
    sigaddset(&sigpipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &sigpipe_, &before_);
  }
  SigpipeBlock(const SigpipeBlock&) = delete;
  SigpipeBlock& operator=(const SigpipeBlock&) = delete;
  ~SigpipeBlock() {
    if (!was_pending_) {
      const timespec no_wait{};
      while (sigtimedwait(&sigpipe_, nullptr, &no_wait) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t sigpipe_{}, before_{};
  bool was_pending_ = false;
};

/// posix_spawn's two descriptions of the child, freed together.
class SpawnPlan {
 public:
  SpawnPlan() {
    check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
    const int error = posix_spawnattr_init(&attributes_);
    if (error != 0) posix_spawn_file_actions_destroy(&actions_);
    check(error, "posix_spawnattr_init");
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }

  void set_streams(int input, int errors) {
    check(posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO), "dup2");
    check(posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0), "open");
    check(posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO), "dup2");
  }

  /// Gives the child its own process group, no blocked signals, and default actions for signals that we may ignore.
  void set_signals() {
    sigset_t none;
    sigset_t usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD}) sigaddset(&usual, signal);
    check(posix_spawnattr_setsigmask(&attributes_, &none), "setsigmask");
    check(posix_spawnattr_setsigdefault(&attributes_, &usual), "setsigdefault");
    check(posix_spawnattr_setpgroup(&attributes_, 0), "setpgroup");
    check(
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF),
        "setflags");
  }

  pid_t spawn(const std::vector<std::string>& arguments) const {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t pid = -1;
    check(posix_spawnp(&pid, argv[0], &actions_, &attributes_, argv.data(), environ), argv[0]);
    return pid;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

/// A thread that reads the child's standard error and keeps its end, so the child never waits for us. The owner stops
/// it: a program that left the child's process group may hold the pipe open for long.
class Process::Drain {
 public:
  explicit Drain(Descriptor errors) : errors_(std::move(errors)), stop_(::eventfd(0, EFD_CLOEXEC)) {
    check(stop_.get() < 0 ? errno : 0, "eventfd");
    check(::fcntl(errors_.get(), F_SETFL, O_NONBLOCK) != 0 ? errno : 0, "fcntl");
    // A new thread inherits the mask. Signals belong to the threads of the host program.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      thread_ = std::thread([this] { run(); });
    } catch (...) {
      pthread_sigmask(SIG_SETMASK, &before, nullptr);
      throw;
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  Drain(const Drain&) = delete;
  Drain& operator=(const Drain&) = delete;
  ~Drain() { stop(); }

  void stop() noexcept {
    if (!thread_.joinable()) return;
    eventfd_write(stop_.get(), 1);
    thread_.join();
  }

  const std::string& text() const { return text_; }
  bool cut() const { return cut_; }

 private:
  void run() {
    pollfd waits[2] = {{errors_.get(), POLLIN, 0}, {stop_.get(), POLLIN, 0}};
    bool open = true;
    while (open && waits[1].revents == 0) {
      if (::poll(waits, 2, -1) < 0 && errno != EINTR) return;
      open = read_available();
    }
  }

  /// @return  false at the end of the pipe.
  bool read_available() {
    char buffer[4096];
    for (;;) {
      const ssize_t got = ::read(errors_.get(), buffer, sizeof buffer);
      if (got == 0) return false;
      if (got < 0) return errno == EAGAIN || errno == EINTR;
      text_.append(buffer, static_cast<std::size_t>(got));
      if (text_.size() > kKeptStderr) {
        text_.erase(0, text_.size() - kKeptStderr);
        cut_ = true;
      }
    }
  }

  Descriptor errors_;
  Descriptor stop_;
  std::string text_;
  bool cut_ = false;
  std::thread thread_;
};

std::string Process::Exit::text() const {
  if (signal != 0) return fmt::format("was ended by signal {} ({})", signal, ::strsignal(signal));
  return fmt::format("ended with status {}", status);
}

Process::Process(const std::vector<std::string>& arguments) {
  Pipe input = make_pipe();
  Pipe errors = make_pipe();
  // A frame is far larger than the usual 64 KiB; a larger pipe means fewer wake-ups. A refusal is harmless.
  ::fcntl(input.write.get(), F_SETPIPE_SZ, 1 << 20);
  // The thread starts before the child: if it cannot start, there is no child to clean up.
  drain_ = std::make_unique<Drain>(std::move(errors.read));
  SpawnPlan plan;
  plan.set_streams(input.read.get(), errors.write.get());
  plan.set_signals();
  pid_ = plan.spawn(arguments);
  input_ = std::move(input.write);
}

Process::~Process() {
  kill();
}

bool Process::write(std::span<const std::uint8_t> bytes) {
  const SigpipeBlock no_sigpipe;
  while (!bytes.empty()) {
    const ssize_t put = ::write(input_.get(), bytes.data(), bytes.size());
    if (put >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(put));
    } else if (errno == EPIPE || errno == EBADF) {
      return false;
    } else if (errno != EINTR) {
      check(errno, "write to a program");
    }
  }
  return true;
}

Process::Exit Process::finish() {
  reap();
  return exit_;
}

void Process::kill() noexcept {
  if (pid_ > 0) ::kill(-pid_, SIGKILL);
  reap();
}

void Process::reap() noexcept {
  input_.close();
  if (pid_ <= 0) return;
  // Wait without reaping first. While the leader is a zombie, the numbers of its process and group stay reserved, so
  // the programs that it left running can be killed safely.
  siginfo_t ended{};
  while (::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  ::kill(-pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  exit_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  exit_.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  drain_->stop();
}

std::string Process::last_lines() const {
  std::string_view text = drain_->text();
  const std::size_t first_newline = text.find('\n');
  if (drain_->cut() && first_newline != std::string_view::npos) text.remove_prefix(first_newline + 1);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace morphkit::media
