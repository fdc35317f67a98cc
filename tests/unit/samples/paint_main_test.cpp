// The program that paints, as a script starts it.

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "morph/project/project.h"
#include "samples/samples.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::samples {
namespace {

using test::contains;
using test::read_text;

class PaintProgram : public testing::Test {
 protected:
  /// @return the exit code; what the program says is in `out_` and `err_`.
  int run(const std::string& arguments) {
    const std::string command =
        MORPHKIT_PAINT " " + arguments + " > '" + out_.string() + "' 2> '" + err_.string() + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out.txt", err_ = folder_ / "err.txt";
};

TEST_F(PaintProgram, PutsEverySampleIntoTheFolder) {
  const std::filesystem::path all = folder_ / "all";
  ASSERT_EQ(run("'" + all.string() + "'"), 0) << read_text(err_);
  for (const std::string& name : names()) {
    const std::filesystem::path file = all / (name + ".json");
    EXPECT_TRUE(contains(read_text(out_), file.string() + "\n")) << read_text(out_);
    const project::Project project = project::load(file);
    for (const project::Picture& picture : project.pictures)
      EXPECT_TRUE(std::filesystem::exists(project::resolve(project, picture.image))) << picture.image;
  }
}

TEST_F(PaintProgram, WrongUseAndFailuresHaveExitCodes) {
  EXPECT_EQ(run(""), 2);
  EXPECT_TRUE(contains(read_text(err_), "usage:")) << read_text(err_);
  EXPECT_EQ(run("a b"), 2);
  test::write_text(folder_ / "file", "");
  EXPECT_EQ(run("'" + (folder_ / "file/below").string() + "'"), 1);
  EXPECT_TRUE(contains(read_text(err_), "below")) << read_text(err_);
}

}  // namespace
}  // namespace morphkit::samples
