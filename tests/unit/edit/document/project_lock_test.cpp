#include "cli/edit/document/project_lock.h"

#include <sys/stat.h>
#include <unistd.h>

#include <optional>

#include <gtest/gtest.h>

#include "cli/edit/document/storage.h"
#include "tests/support/errors.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::edit {
namespace {

using test::contains;
using test::TemporaryFolder;
using test::write_text;
using Names = std::vector<std::string>;

TEST(ProjectLock, EveryEditorHasAnAutosaveOfItsOwn) {
  const TemporaryFolder folder;
  {
    const ProjectLock first = ProjectLock::claim(folder / "pair.json");
    EXPECT_EQ(first.autosave_file(), folder / "pair.json.autosave");
    EXPECT_TRUE(first.others().empty());
    const ProjectLock second = ProjectLock::claim(folder / "pair.json");
    EXPECT_EQ(second.autosave_file(), folder / "pair.json.autosave-2");
    ASSERT_EQ(second.others().size(), 1U);
    EXPECT_TRUE(second.others()[0].starts_with("process " + std::to_string(::getpid()) + " on ")) << second.others()[0];
  }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(ProjectLock, TheAutosaveOfALivingEditorIsNotOffered) {
  const TemporaryFolder folder;
  const ProjectLock living = ProjectLock::claim(folder / "pair.json");
  write_text(living.autosave_file(), "its work");
  const ProjectLock mine = ProjectLock::claim(folder / "pair.json");
  EXPECT_NE(mine.autosave_file(), living.autosave_file());
}

TEST(ProjectLock, AnOrphanIsFoundByWhoeverComesNext) {
  const TemporaryFolder folder;
  write_text(folder / "pair.json.autosave-2", "left behind");
  const ProjectLock finder = ProjectLock::claim(folder / "pair.json");
  EXPECT_EQ(finder.autosave_file(), folder / "pair.json.autosave-2");
  const ProjectLock next = ProjectLock::claim(folder / "pair.json");
  EXPECT_EQ(next.autosave_file(), folder / "pair.json.autosave");
  EXPECT_EQ(next.others().size(), 1U);
}

TEST(ProjectLock, ALockFileOfADeadEditorLocksNothing) {
  const TemporaryFolder folder;
  write_text(folder / ".pair.json.autosave.lock", "process 1 on elsewhere\n");
  const ProjectLock mine = ProjectLock::claim(folder / "pair.json");
  EXPECT_EQ(mine.autosave_file(), folder / "pair.json.autosave");
  EXPECT_TRUE(mine.others().empty());
}

TEST(ProjectLock, WithoutAWritableFolderTheFirstPlaceIsUnprotected) {
  const ProjectLock mine = ProjectLock::claim("/proc/none/pair.json");
  EXPECT_EQ(mine.autosave_file(), "/proc/none/pair.json.autosave");
  EXPECT_TRUE(mine.others().empty());
}

}  // namespace
}  // namespace morphkit::edit
