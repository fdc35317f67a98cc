// Keys of a project on the command line: --set, and the options that are short for it.

#include "cli/project_argument.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "cli/exit_code.h"
#include "cli/program.h"
#include "morph/project/project.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::cli {
namespace {

using test::contains;

constexpr const char* kPair = R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"},
  "features": [{"id": "nose", "point": {"source": [1, 2], "destination": [3, 4]}}]})";

ProjectChanges sets(const std::vector<std::string>& sets) {
  ProjectChanges changes;
  changes.sets = sets;
  return changes;
}

project::Project changed(const ProjectChanges& changes) {
  project::Project project = project::parse(kPair, "pair.json");
  apply_changes(changes, project);
  return project;
}

std::string refusal(const ProjectChanges& changes) {
  project::Project project = project::parse(kPair, "pair.json");
  const project::Project before = project;
  try {
    apply_changes(changes, project);
  } catch (const ArgumentError& error) {
    EXPECT_TRUE(same_document(project, before));
    return error.what();
  }
  return "accepted";
}

TEST(ProjectChanges, SetAnyKey) {
  const project::Project project =
      changed(sets({"warp.filter=lanczos", "output.size=[64, 48]", "features/nose.point.source=[5, 6.5]",
                    "features/nose.warp.a=4", "source.image=a=b.png"}));
  EXPECT_EQ(project.warp.filter, warp::Filter::kLanczos);
  EXPECT_EQ(project.output.size, cv::Size(64, 48));
  EXPECT_EQ(project.features[0].places[project::kSource], (project::Points{{5, 6.5}}));
  EXPECT_EQ(project.features[0].pull.a, 4);
  EXPECT_EQ(project.pictures[project::kSource].image, "a=b.png") << "the first = ends the path";
  EXPECT_EQ(project.file, "pair.json");
}

TEST(ProjectChanges, KeepPicturesWithControlCharactersInTheirNames) {
  project::Project project;
  project.pictures[project::kSource].image = "a\001.png";
  project.pictures[project::kDestination].image = "b\n.png";
  ProjectChanges changes;
  changes.keys.push_back({KeyOption::kFilter, "lanczos"});
  apply_changes(changes, project);
  EXPECT_EQ(project.warp.filter, warp::Filter::kLanczos);
  EXPECT_EQ(project.pictures[project::kSource].image, "a\001.png");
  EXPECT_EQ(project.pictures[project::kDestination].image, "b\n.png");
}

TEST(ProjectChanges, NothingIsNoChange) {
  EXPECT_TRUE(same_document(changed({}), project::parse(kPair, "pair.json")));
}

TEST(ProjectChanges, TheLastSetWinsAndSetWinsOverAShortOption) {
  ProjectChanges changes = sets({"output.frames=5", "output.frames=7"});
  changes.keys.push_back({KeyOption::kFrameCount, "3"});
  changes.keys.push_back({KeyOption::kFps, "29.97"});
  const project::Project project = changed(changes);
  EXPECT_EQ(project.output.frames, 7);
  EXPECT_EQ(project.output.fps, (project::Rate{30000, 1001}));
}

TEST(ProjectChanges, WhatIsWrongIsNamedWithItsOption) {
  EXPECT_EQ(refusal(sets({"warp.fitler=area"})),
            "--set: warp.fitler: unknown key \"fitler\"; did you mean \"filter\"?");
  EXPECT_EQ(refusal(sets({"warp.filter=area", "warp.b=9"})), "--set: warp.b: 9 is out of range; expected 0 to 8");
  EXPECT_TRUE(contains(refusal(sets({"features/noes.point.source=[1, 2]"})), "did you mean \"nose\"?"));
  for (const char* text : {"warp.b", "=3", ""})
    EXPECT_EQ(refusal(sets({text})),
              std::string("--set: '") + text + "' is no change; write PATH=VALUE, as in warp.filter=lanczos");
  ProjectChanges changes;
  changes.keys.push_back({KeyOption::kFrameCount, "0"});
  EXPECT_EQ(refusal(changes), "--frame-count: 0 is out of range; expected 1 to 10000000");
  changes.keys[0] = {KeyOption::kSize, "640"};
  EXPECT_EQ(refusal(changes), "--size: '640' is no size; write WIDTHxHEIGHT, as in 1280x720");
}

TEST(ProjectChanges, EveryCommandThatTakesAProjectTakesThem) {
  for (const CommandShape& command : program_shape().commands) {
    const std::vector<std::string> with_project = {"edit", "morph", "warp", "map", "export", "check", "info", "bench"};
    const std::vector<std::string> options = option_names(command);
    EXPECT_EQ(std::ranges::count(options, "--set"), std::ranges::count(with_project, command.name)) << command.name;
  }
}

TEST(SeenFrom, BeginsAtTheFolderOfTheProject) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "projects/new");
  EXPECT_EQ(relative_to_project("pair.json", "a.png"), "a.png");
  EXPECT_EQ(relative_to_project("projects/pair.json", "plates/a.png"), "../plates/a.png");
  EXPECT_EQ(relative_to_project(folder / "projects/pair.json", folder / "a.png"), "../a.png");
}

TEST(SeenFrom, FollowsLinksOfFoldersAndKeepsThePicturesName) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "shots/one");
  std::filesystem::create_directory_symlink("shots/one", folder / "link");
  test::write_text(folder / "real.png", "");
  std::filesystem::create_symlink("real.png", folder / "a.png");
  EXPECT_EQ(relative_to_project(folder / "link/pair.json", folder / "a.png"), "../../a.png");
}

class SetOption : public testing::Test {
 protected:
  SetOption() { test::write_text(folder_ / "pair.json", kPair); }

  test::RunResult run(const std::vector<std::string>& arguments) const {
    test::RunOptions options;
    options.folder = folder_.path();
    return test::run_morphkit(arguments, options);
  }

  test::TemporaryFolder folder_;
};

TEST_F(SetOption, TakesOneValueAndMayBeRepeated) {
  const test::RunResult result = run({"info", "--set", "output.frames=7", "--set=output.start=10", "pair.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "frames 10-16")) << result.out;
  EXPECT_EQ(test::read_text(folder_ / "pair.json"), kPair) << "the file stays as it is";
}

TEST_F(SetOption, IsWrongUsageIfItCannotBeDone) {
  const test::RunResult unknown = run({"check", "pair.json", "--set", "wrap.b=1"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "morphkit: error: --set: wrap.b: unknown key \"wrap\"; did you mean \"warp\"?\n");
  EXPECT_EQ(run({"map", "pair.json", "-t", "0", "-o", "map.exr", "--set", "warp.b"}).exit_code, 2);
  EXPECT_EQ(run({"info", "pair.json", "--set"}).exit_code, 2);
  const test::RunResult picture = run({"info", "a.png", "--set", "warp.b=1"});
  EXPECT_EQ(picture.exit_code, 2);
  EXPECT_TRUE(contains(picture.err, "--set: goes with a project (*.json)")) << picture.err;
}

}  // namespace
}  // namespace morphkit::cli
