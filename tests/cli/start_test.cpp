// Tests cli/become_renderer.cpp.
// The program that is started first is small: it loads no picture library and no window toolkit.

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

/// The dynamic linker's list of what it loads, in place of a run of the program.
std::string libraries() {
  RunOptions options;
  options.environment = {"LD_TRACE_LOADED_OBJECTS=1"};
  return run_morphkit({"--version"}, options).out;
}

TEST(Start, LoadsNoPictureLibraryAndNoWindowToolkit) {
  const std::string list = libraries();
  ASSERT_NE(list.find("libc.so"), std::string::npos) << list;
  for (const char* heavy : {"OpenImageIO", "opencv_highgui", "opencv_imgcodecs", "Qt5", "avcodec"})
    EXPECT_EQ(list.find(heavy), std::string::npos) << heavy << " in\n" << list;
  EXPECT_LT(std::count(list.begin(), list.end(), '\n'), 40) << list;
}

TEST(Start, ACopyWithoutItsOtherPartSaysWhatIsMissing) {
  const TemporaryFolder folder;
  const std::filesystem::path lonely = folder.path() / "bin" / "morphkit";
  std::filesystem::create_directories(lonely.parent_path());
  std::filesystem::copy_file(morphkit_program(), lonely);
  EXPECT_EQ(run_program(lonely, {"--version"}).exit_code, 0);
  const RunResult result = run_program(lonely, {"info", "missing.png"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("morphkit-render: cannot be started"), std::string::npos) << result.err;
}

TEST(Start, TheOtherPartIsFoundThroughALink) {
  const TemporaryFolder folder;
  const std::filesystem::path link = folder.path() / "morphkit";
  std::filesystem::create_symlink(morphkit_program(), link);
  const RunResult result = run_program(link, {"info", "missing.png"});  // morphkit-render says what is wrong
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("missing.png: does not exist"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace morphkit::test
