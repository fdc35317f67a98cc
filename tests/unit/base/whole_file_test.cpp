#include "base/whole_file.h"

#include <sys/stat.h>

#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

TEST(WholeFile, IsReadByteByByte) {
  const TemporaryFolder folder;
  const std::string text = std::string("a\0\r\n", 4) + std::string(200'000, 'x');
  write_text(folder / "a", text);
  EXPECT_EQ(read_file(folder / "a", "test", text.size()), text);
  write_text(folder / "empty", "");
  EXPECT_EQ(read_file(folder / "empty", "test", 0), "");
}

TEST(WholeFile, PipesAreRead) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { write_text(pipe, "through a pipe"); });
  EXPECT_EQ(read_file(pipe, "test", 100), "through a pipe");
  writer.join();
}

TEST(WholeFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  write_text(folder / "large", std::string((2 << 20) + 1, 'x'));
  const auto message = [&](const std::string& name) {
    return std::string(error_of([&] { read_file(folder / name, "test", 2 << 20); }).what());
  };
  EXPECT_TRUE(contains(message("large"), "larger than 2 MB; this is no test"));
  EXPECT_TRUE(contains(message("none"), "cannot be read: No such file"));
  EXPECT_TRUE(contains(message(""), "is a directory; expected a test file"));
}

}  // namespace
}  // namespace morphkit::test
