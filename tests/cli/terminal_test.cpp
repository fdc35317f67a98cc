#include "cli/terminal.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

namespace morphkit::cli {
namespace {

TEST(ProgressText, TellsRateAndTimeLeftOnceThereIsARate) {
  EXPECT_EQ(progress_text({0, 0, 10, 0}, "frames"), "0/10 frames");
  EXPECT_EQ(progress_text({0, 4, 10, 1}, "frames"), "4/10 frames (4 already there)");
  EXPECT_EQ(progress_text({2, 4, 10, 1}, "frames"), "6/10 frames (4 already there), 2.0 frames/s, 2 s left");
  EXPECT_EQ(progress_text({10, 0, 10, 5}, "frames"), "10/10 frames, 2.0 frames/s, 5 s");
  EXPECT_EQ(progress_text({1, 0, 101, 1}, "frames"), "1/101 frames, 1.0 frames/s, 1:40 min left");
  EXPECT_EQ(progress_text({1, 0, 3661, 2}, "frames"), "1/3661 frames, 0.5 frames/s, 2:02 h left");
}

class ProgressBarLines : public testing::Test {
 protected:
  std::string lines_of(Verbosity verbosity, int total) {
    std::FILE* file = std::tmpfile();
    {
      Output output(stdout, file, verbosity);
      ProgressBar bar(output, "frames");
      for (int i = 1; i <= total; ++i) bar.update(i, 0, total);
    }
    std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
    std::rewind(file);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
    std::fclose(file);
    return text;
  }
};

TEST_F(ProgressBarLines, AreATenthApartWithoutATerminal) {
  const std::string text = lines_of(Verbosity::kNormal, 1000);
  const auto count = std::count(text.begin(), text.end(), '\n');
  EXPECT_EQ(count, 11);  // the first frame, then every tenth
  EXPECT_NE(text.find("1000/1000 frames"), std::string::npos);
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST_F(ProgressBarLines, AreNotThereWhenQuiet) {
  EXPECT_EQ(lines_of(Verbosity::kQuiet, 1000), "");
}

}  // namespace
}  // namespace morphkit::cli
