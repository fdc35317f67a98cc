// Files appear whole or not at all.

#include <csignal>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFile, IsWholeOrAbsent) {
  const TemporaryFolder folder;
  const fs::path file = folder / "a.txt";
  {
    AtomicFile given_up(file, false);
    write_bytes(given_up.temporary(), {1, 2, 3});
    EXPECT_FALSE(fs::exists(file));
  }
  EXPECT_EQ(folder.names().size(), 0U);
  AtomicFile kept(file, false);
  EXPECT_EQ(kept.temporary().parent_path(), folder.path());
  EXPECT_EQ(kept.temporary().extension(), ".txt");
  EXPECT_EQ(kept.temporary().filename().string().front(), '.');
  kept.write(Bytes{1, 2, 3});
  kept.commit();
  EXPECT_EQ(read_bytes(file), (Bytes{1, 2, 3}));
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(AtomicFile, AnEmptyFileIsNotCommitted) {
  const TemporaryFolder folder;
  {
    AtomicFile file(folder / "a.txt", false);
    EXPECT_EQ(error_of([&] { file.commit(); }).kind(), ErrorKind::kIo);
  }
  EXPECT_EQ(folder.names().size(), 0U);
}

TEST(AtomicFile, DoesNotReplaceAFileThatAppearsMeanwhile) {
  const TemporaryFolder folder;
  AtomicFile file(folder / "a.txt", false);
  file.write(Bytes{1});
  write_bytes(folder / "a.txt", {9});
  EXPECT_THROW(file.commit(), FileExists);
  EXPECT_EQ(read_bytes(folder / "a.txt"), Bytes{9});
}

TEST(AtomicFile, ReplacingKeepsPermissionsAndFollowsLinks) {
  const TemporaryFolder folder;
  write_bytes(folder / "real.txt", {9});
  fs::permissions(folder / "real.txt", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.txt", folder / "link.txt");
  write_file(folder / "link.txt", Bytes{1, 2}, true);
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read_bytes(folder / "real.txt"), (Bytes{1, 2}));
  EXPECT_EQ(fs::status(folder / "real.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(error_of([] { write_file("/dev/null", Bytes{1}, true); }).kind(), ErrorKind::kIo);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, AReadOnlyFileIsReplacedByAReadOnlyFile) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.txt", {9});
  fs::permissions(folder / "a.txt", fs::perms::owner_read);
  AtomicFile file(folder / "a.txt", true);
  const fs::perms meanwhile = fs::status(file.temporary()).permissions();
  EXPECT_EQ(meanwhile, fs::perms::owner_read | fs::perms::owner_write) << "others see nothing before the time";
  file.write(Bytes{1, 2});
  file.commit();
  EXPECT_EQ(read_bytes(folder / "a.txt"), (Bytes{1, 2}));
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms::owner_read);
}

TEST(AtomicFile, BadFileNamesGiveErrorsWithTheReason) {
  const TemporaryFolder folder;
  const auto refused = [&](const fs::path& file, const std::string& says) {
    const Error error = error_of([&] { write_file(file, Bytes{1}, true); });
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
    EXPECT_EQ(error.place(), file.string());
    EXPECT_TRUE(contains(error.message(), says)) << error.what();
  };
  refused(folder.path(), "is a folder");
  refused(folder / "missing" / "a.txt", "does not exist; create it first");
  write_bytes(folder / "plain", {1});
  refused(folder / "plain" / "a.txt", "");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(AtomicFile, LongNamesHaveTemporaryNames) {
  const TemporaryFolder folder;
  const fs::path file = folder / (std::string(250, 'x') + ".txt");
  write_file(file, Bytes{1}, false);
  EXPECT_EQ(read_bytes(file), Bytes{1});
}

/// A process of its own that has temporary files and waits; killed when the test ends.
class Writer {
 public:
  explicit Writer(const std::vector<fs::path>& targets) {
    int ready[2];
    if (pipe(ready) != 0) throw std::runtime_error("pipe");
    process_ = fork();
    if (process_ == 0) {
      std::vector<std::unique_ptr<AtomicFile>> files;
      for (const fs::path& target : targets) files.push_back(std::make_unique<AtomicFile>(target, false));
      if (::write(ready[1], "x", 1) != 1) _exit(1);
      for (;;) pause();
    }
    char told = 0;
    EXPECT_EQ(::read(ready[0], &told, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Writer() { kill(); }

  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

TEST(AtomicFile, RemovesWhatAKilledProgramLeft) {
  const TemporaryFolder folder;
  Writer writer({folder / "a.b.txt", folder / "other.txt"});
  { const AtomicFile file(folder / "a.b.txt", false); }
  EXPECT_EQ(folder.names().size(), 2U) << "a file in work was removed";
  writer.kill();
  { const AtomicFile file(folder / "a.b.txt", false, Leftovers::kKeep); }
  EXPECT_EQ(folder.names().size(), 2U);
  { const AtomicFile file(folder / "a.b.txt", false); }
  ASSERT_EQ(folder.names().size(), 1U);
  EXPECT_TRUE(folder.names().front().starts_with(".other."));
  remove_leftovers(folder.path(), [](const std::string& name) { return name == "other.txt"; });
  EXPECT_EQ(folder.names().size(), 0U);
}

TEST(AtomicFile, KeepsItsOwnFilesInWorkAndNamesOfOtherKinds) {
  const TemporaryFolder folder;
  const AtomicFile first(folder / "a.txt", false);
  const AtomicFile second(folder / "a.txt", false);
  EXPECT_EQ(folder.names().size(), 2U);
  const std::vector<std::string> others = {".a.12.txt",     ".a.12.x.tmp.txt", "a.12.3.tmp.txt",
                                           ".12.3.tmp.txt", ".a.12.3.tmptxt",  ".a.12.3.tmp.txt.bak.tmp2",
                                           ".a..3.tmp.txt"};
  for (const std::string& name : others) write_bytes(folder / name, {1});
  remove_leftovers(folder.path(), [](const std::string&) { return true; });
  EXPECT_EQ(folder.names().size(), 2U + others.size());
}

}  // namespace
}  // namespace morphkit::test
