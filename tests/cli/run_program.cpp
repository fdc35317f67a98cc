#include "tests/cli/run_program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace morphkit::test {
namespace {

constexpr int kSilenceLimit_ms = 120'000;

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

class Pipe {
 public:
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) check(errno, "pipe2");
    read_ = ends[0];
    write_ = ends[1];
  }
  ~Pipe() {
    close(read_);
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int read_end() const { return read_; }
  int write_end() const { return write_; }
  void close_write() {
    if (write_ >= 0) close(write_);
    write_ = -1;
  }

 private:
  int read_ = -1, write_ = -1;
};

std::vector<std::string> environment_with(const std::vector<std::string>& changes) {
  std::vector<std::string> result = changes;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('=') + 1);
    bool changed = false;
    for (const std::string& change : changes) changed = changed || change.starts_with(name);
    if (!changed) result.push_back(text);
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

void describe_streams(posix_spawn_file_actions_t& actions, const Pipe& out, const Pipe& err,
                      const RunOptions& options) {
  check(posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0), "stdin");
  if (options.close_output) {
    check(posix_spawn_file_actions_addclose(&actions, 1), "stdout");
  } else if (!options.output_to.empty()) {
    check(posix_spawn_file_actions_addopen(&actions, 1, options.output_to.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644),
          "stdout");
  } else {
    check(posix_spawn_file_actions_adddup2(&actions, out.write_end(), 1), "stdout");
  }
  check(posix_spawn_file_actions_adddup2(&actions, err.write_end(), 2), "stderr");
  if (!options.folder.empty()) {
    check(posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str()), "folder");
  }
}

/// Signals that this process may have been started to ignore (a background job does) are as usual for the program.
void default_signals(posix_spawnattr_t& attributes) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, number);
  check(posix_spawnattr_setsigdefault(&attributes, &signals), "signals");
  check(posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF), "signals");
}

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, const Pipe& out,
            const Pipe& err, const RunOptions& options) {
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), program.string());
  std::vector<std::string> environment = environment_with(options.environment);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  check(posix_spawn_file_actions_init(&actions), "actions");
  check(posix_spawnattr_init(&attributes), "attributes");
  describe_streams(actions, out, err, options);
  default_signals(attributes);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, program.c_str(), &actions, &attributes, pointers(words).data(), pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  check(error, program.c_str());
  return child;
}

/// Until the child has taken a signal; two that wait to be taken are one.
void wait_until_taken(pid_t child, int signal_number) {
  const std::string file = "/proc/" + std::to_string(child) + "/status";
  const auto waits = [&] {
    std::ifstream status(file);
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("ShdPnd:"))
        return (std::stoull(line.substr(line.find('\t') + 1), nullptr, 16) >> (signal_number - 1) & 1) != 0;
    return false;
  };
  while (waits()) sched_yield();
}

/// Reads both streams to their ends, and sends the signal when the marker has appeared.
void listen(pid_t child, const Pipe& out, const Pipe& err, const RunOptions& options, RunResult& result) {
  std::array<pollfd, 2> streams{{{out.read_end(), POLLIN, 0}, {err.read_end(), POLLIN, 0}}};
  const std::array<std::string*, 2> texts{&result.out, &result.err};
  bool sent = options.send == 0;
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    const int ready = poll(streams.data(), streams.size(), kSilenceLimit_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) kill(child, SIGKILL);
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].fd < 0 || (streams[i].revents == 0 && ready > 0)) continue;
      std::array<char, 4096> buffer{};
      const ssize_t count = read(streams[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else {
        streams[i].fd = -1;
      }
    }
    const bool seen =
        result.out.find(options.marker) != std::string::npos || result.err.find(options.marker) != std::string::npos;
    if (!sent && seen) {
      for (int i = 0; i < options.send_count; ++i) {
        if (i > 0) wait_until_taken(child, options.send);
        kill(child, options.send);
      }
      sent = true;
    }
  }
}

}  // namespace

RunResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      const RunOptions& options) {
  Pipe out;
  Pipe err;
  const pid_t child = spawn(program, arguments, out, err, options);
  out.close_write();
  err.close_write();
  RunResult result;
  listen(child, out, err, options, result);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

std::filesystem::path morphkit_program() {
  return MORPHKIT_PROGRAM;
}

RunResult run_morphkit(const std::vector<std::string>& arguments, const RunOptions& options) {
  return run_program(MORPHKIT_PROGRAM, arguments, options);
}

}  // namespace morphkit::test
