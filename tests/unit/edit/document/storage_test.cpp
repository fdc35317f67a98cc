#include "cli/edit/document/storage.h"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::edit {
namespace {

namespace fs = std::filesystem;

project::Project in_file(const fs::path& file) {
  project::Project project = test::small_project();
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  project.file = file;
  return project;
}

/// Writes as another program would, at another time.
void edit_by_hand(const fs::path& file, const std::string& text) {
  const fs::file_time_type before = fs::exists(file) ? fs::last_write_time(file) : fs::file_time_type::clock::now();
  test::write_text(file, text);
  fs::last_write_time(file, before + std::chrono::seconds(2));
}

TEST(Storage, WhatIsSavedIsReadBackEqualAndKeepsItsSpelling) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "pair.json");
  Storage storage(project);
  const project::Project saved = storage.save(project);
  ASSERT_TRUE(saved.original);
  EXPECT_EQ(*saved.original, test::read_text(project.file));
  EXPECT_TRUE(project::same_document(project::load(project.file), project));
  EXPECT_FALSE(storage.changed_by_others());
}

TEST(Storage, NoticesWhatOthersWrite) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "pair.json");
  Storage storage(project);
  project = storage.save(project);
  std::string text = *project.original;
  edit_by_hand(project.file, text);
  EXPECT_FALSE(storage.changed_by_others()) << "touched, but the same";
  text.replace(text.find("brow"), 4, "eyes");
  edit_by_hand(project.file, text);
  EXPECT_TRUE(storage.changed_by_others());
  EXPECT_EQ(storage.read().features.front().id, "eyes");
  EXPECT_TRUE(storage.changed_by_others()) << "it has only been read";
  storage.accept();
  EXPECT_FALSE(storage.changed_by_others());
}

TEST(Storage, AFileThatAppearsIsAChangeByOthers) {
  const test::TemporaryFolder folder;
  Storage storage(in_file(folder / "pair.json"));
  EXPECT_FALSE(storage.changed_by_others());
  test::write_text(folder / "pair.json", "{}");
  EXPECT_TRUE(storage.changed_by_others());
}

TEST(Storage, GivesBackAnAutosaveUntilTheProjectIsSaved) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "pair.json");
  {
    Storage storage(project);
    EXPECT_FALSE(storage.recovery());
    ASSERT_TRUE(storage.autosave(project));
    storage.finish();
    EXPECT_EQ(storage.autosave_problem(), "");
  }
  EXPECT_FALSE(fs::exists(project.file));
  Storage storage(project);
  const std::optional<Recovery> recovery = storage.recovery();
  ASSERT_TRUE(recovery);
  EXPECT_TRUE(project::same_document(*recovery->project, project));
  EXPECT_EQ(recovery->project->file, project.file);
  EXPECT_EQ(recovery->when.size(), std::string("2026-11-23 14:05").size());
  storage.save(project);
  EXPECT_FALSE(storage.recovery());
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pair.json"});
}

/// As in a folder that has become read-only: what could not be written there is found where it was rescued to.
TEST(Storage, FindsWhatWasRescuedElsewhere) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "gone" / "pair.json");
  const fs::path rescued = Storage(project).rescue(project);
  EXPECT_NE(rescued.parent_path(), project.file.parent_path());
  Storage storage(project);
  const std::optional<Recovery> recovery = storage.recovery();
  ASSERT_TRUE(recovery);
  EXPECT_TRUE(project::same_document(*recovery->project, project));
  EXPECT_FALSE(Storage(in_file(folder / "other" / "pair.json")).recovery()) << "a project of the same name";
  fs::create_directory(folder / "gone");
  storage.save(project);
  EXPECT_FALSE(fs::exists(rescued));
}

TEST(Storage, GivesAnAutosaveThatItCannotReadAnotherName) {
  const test::TemporaryFolder folder;
  Storage storage(in_file(folder / "pair.json"));
  test::write_text(folder / "pair.json.autosave.1", "an earlier one");
  test::write_text(storage.autosave_file(), "no project");
  ASSERT_TRUE(storage.recovery());
  EXPECT_FALSE(storage.recovery()->project);
  EXPECT_EQ(storage.set_autosave_aside(), folder / "pair.json.autosave.2");
  EXPECT_EQ(test::read_text(folder / "pair.json.autosave.2"), "no project");
  EXPECT_EQ(test::read_text(folder / "pair.json.autosave.1"), "an earlier one");
  EXPECT_FALSE(storage.recovery());
}

TEST(Storage, TellsOfNewsOnce) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "pair.json");
  Storage storage(project);
  project = storage.save(project);
  EXPECT_FALSE(storage.new_change_by_others());
  edit_by_hand(project.file, "{");
  EXPECT_TRUE(storage.new_change_by_others());
  EXPECT_FALSE(storage.new_change_by_others());
  EXPECT_TRUE(storage.changed_by_others());
  edit_by_hand(project.file, "{}");
  EXPECT_TRUE(storage.new_change_by_others()) << "there are more";
}

TEST(Storage, WhatWasWrittenSinceTheProjectWasLoadedIsAChangeByOthers) {
  const test::TemporaryFolder folder;
  project::Project project = in_file(folder / "pair.json");
  project = Storage(project).save(project);
  edit_by_hand(project.file, "{}");
  EXPECT_TRUE(Storage(project).changed_by_others());
}

TEST(Storage, RefusesProjectsThatCouldNeverBeSaved) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(require_savable(in_file(folder / "pair.json")));
  EXPECT_TRUE(folder.names().empty());
  EXPECT_THROW(require_savable(in_file(folder / "missing" / "pair.json")), Error);
  project::Project latin = in_file(folder / "pair.json");
  latin.pictures[project::kSource].image = "caf\xE9.png";
  EXPECT_THROW(require_savable(latin), Error);
}

TEST(Storage, TellsOfFoldersThatCannotBeWritten) {
  const test::TemporaryFolder folder;
  const project::Project project = in_file(folder / "missing" / "pair.json");
  Storage storage(project);
  EXPECT_THROW(storage.save(project), Error);
  storage.autosave(project);
  storage.finish();
  EXPECT_NE(storage.autosave_problem(), "");
  EXPECT_EQ(storage.autosave_problem(), "") << "told once";
}

}  // namespace
}  // namespace morphkit::edit
