#include "morph/media/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

#include "tests/unit/media/sink_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::has_children;
using test::read_bytes;
using test::TemporaryFolder;

std::vector<std::string> shell(const std::string& script) {
  return {"sh", "-c", script};
}

Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

TEST(Process, FeedsStandardInputAndReportsTheEnd) {
  const TemporaryFolder folder;
  Process process({"sh", "-c", "cat > \"$1\"", "sh", (folder / "it's $HOME.txt").string()});
  Bytes sent;
  for (int i = 0; i < 300; ++i) {
    const Bytes part(10007, static_cast<std::uint8_t>(i));
    ASSERT_TRUE(process.write(part));
    sent.insert(sent.end(), part.begin(), part.end());
  }
  EXPECT_TRUE(process.finish().ok());
  EXPECT_EQ(read_bytes(folder / "it's $HOME.txt"), sent);
  EXPECT_FALSE(has_children());
}

TEST(Process, ReportsStatusAndSignal) {
  Process failing(shell("exit 3"));
  EXPECT_EQ(failing.finish().status, 3);
  EXPECT_EQ(failing.finish().text(), "ended with status 3");
  Process killed(shell("kill -9 $$"));
  EXPECT_EQ(killed.finish().signal, SIGKILL);
  EXPECT_FALSE(killed.finish().ok());
  EXPECT_EQ(killed.finish().text(), "was ended by signal 9 (Killed)");
}

TEST(Process, AMissingProgramIsAnError) {
  try {
    const Process process({"no-such-program-morphkit"});
    FAIL() << "started";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
  EXPECT_FALSE(has_children());
}

TEST(Process, KeepsTheLastLinesOfStandardError) {
  Process process(shell("echo out; echo one >&2; echo two >&2"));
  process.finish();
  EXPECT_EQ(process.last_lines(), "one\ntwo");
}

TEST(Process, ManyErrorLinesNeitherBlockNorFillMemory) {
  Process process(shell("yes 'a line of complaint' | head -n 200000 >&2; echo the end >&2; cat > /dev/null"));
  EXPECT_TRUE(process.write(bytes_of("x")));
  EXPECT_TRUE(process.finish().ok());
  const std::string lines = process.last_lines();
  EXPECT_LE(lines.size(), 4096U);
  EXPECT_TRUE(lines.starts_with("a line of complaint\n")) << lines.substr(0, 40);
  EXPECT_TRUE(lines.ends_with("a line of complaint\nthe end"));
}

TEST(Process, WritingToAnEndedProgramReturnsFalseWithoutASignal) {
  Process process(shell("exit 7"));
  const Bytes megabyte(1 << 20);
  bool alive = true;
  for (int i = 0; i < 4 && alive; ++i) alive = process.write(megabyte);
  EXPECT_FALSE(alive);
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
  sigset_t mask;
  pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  EXPECT_EQ(sigismember(&mask, SIGPIPE), 0);
  EXPECT_EQ(process.finish().status, 7);
}

TEST(Process, HasAGroupOfItsOwnAndTheUsualSignals) {
  sigset_t interrupt;
  sigset_t before;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupt, &before);
  // Field 5 of stat is the group; SigBlk is a mask of blocked signals, read by the process itself: a shell blocks them
  // all for a moment while it starts something.
  Process process(shell("echo $$ >&2; cut -d' ' -f5 /proc/self/stat >&2; exec grep SigBlk /proc/self/status >&2"));
  process.finish();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  std::istringstream words(process.last_lines());
  long pid = 0;
  long group = -1;
  std::string label;
  std::string blocked;
  words >> pid >> group >> label >> blocked;
  EXPECT_EQ(pid, group);
  EXPECT_NE(group, ::getpgrp());
  EXPECT_EQ(blocked, "0000000000000000");
}

TEST(Process, KillsTheProgramsThatItLeavesBehind) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  // The sleeper keeps standard error open, too: finish() must not wait for it.
  Process process(shell("sleep 1000 & exit 4"));
  ::close(ends[1]);
  EXPECT_EQ(process.finish().status, 4);
  char none = 0;
  EXPECT_EQ(::read(ends[0], &none, 1), 0) << "the pipe ends when its last writer has ended";
  ::close(ends[0]);
}

TEST(Process, TheDestructorKillsAndReapsARunningProgram) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  {
    const Process process(shell("sleep 1000 & sleep 1000"));
    ::close(ends[1]);
  }
  EXPECT_FALSE(has_children());
  char none = 0;
  EXPECT_EQ(::read(ends[0], &none, 1), 0);
  ::close(ends[0]);
}

TEST(Process, LeaksNoDescriptors) {
  const auto open_descriptors = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const auto before = open_descriptors();
  for (int i = 0; i < 5; ++i) {
    Process process(shell("cat > /dev/null"));
    process.write(bytes_of("x"));
    if (i % 2 == 0) process.finish();
    EXPECT_THROW(Process({"no-such-program-morphkit"}), std::system_error);
  }
  EXPECT_EQ(open_descriptors(), before);
}

}  // namespace
}  // namespace morphkit::media
