// Tests cli/cmd_demo.cpp, cli/run_demo.cpp and samples/names.cpp.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/commands.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

TEST(Demo, ListsItsSamples) {
  const RunResult result = run_morphkit({"demo", "--list"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 4);
  EXPECT_TRUE(result.out.starts_with("portraits    A woman becomes a man")) << result.out;
}

TEST(Demo, WritesPicturesProjectAndFramesAndKeepsWhatSomebodyHasChanged) {
  TemporaryFolder folder;
  const std::string listed = run_morphkit({"demo", "--list"}).out;
  const std::string name = listed.substr(0, listed.find(' '));
  RunOptions options;
  options.folder = folder.path();
  options.environment = {"PATH=/nonexistent"};  // no ffmpeg: numbered pictures
  const std::vector<std::string> command = {"demo", "-n", "2", "-o", "out"};
  const RunResult first = run_morphkit(command, options);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_TRUE(contains(first.err, "ffmpeg is not installed")) << first.err;
  const fs::path project = folder / "out" / (name + ".json");
  EXPECT_TRUE(fs::exists(project));
  EXPECT_TRUE(fs::exists(folder / "out" / (name + ".0001.png")));
  EXPECT_TRUE(fs::exists(folder / "out" / (name + ".0002.png")));
  EXPECT_EQ(run_morphkit({"info", project.string()}).exit_code, 0);

  EXPECT_EQ(run_morphkit(command, options).exit_code, 0) << "nothing was changed";
  const std::string edited = read_text(project) + "\n";
  write_text(project, edited);
  const RunResult changed = run_morphkit(command, options);
  EXPECT_EQ(changed.exit_code, 4);
  EXPECT_TRUE(contains(changed.err, "-y replaces it")) << changed.err;
  EXPECT_EQ(read_text(project), edited);
}

TEST(Demo, RefusesWrongUse) {
  expect_usage_error(run_morphkit({"demo", "no-such-sample"}), "there is no sample 'no-such-sample'");
  expect_usage_error(run_morphkit({"demo", "-n", "0"}), "--frame-count");
  TemporaryFolder folder;
  write_text(folder / "file", "");
  EXPECT_EQ(run_morphkit({"demo", "-o", (folder / "file" / "below").string()}).exit_code, 4);
}

}  // namespace
}  // namespace morphkit::test
