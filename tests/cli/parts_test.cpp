// The pieces of the command line that need no process.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/words.h"
#include "cli/exit_code.h"
#include "cli/frame_range.h"
#include "cli/help_format.h"
#include "cli/report.h"
#include "cli/terminal.h"

namespace morphkit::cli {
namespace {

using Frames = std::vector<int>;

std::string refusal(const std::string& text, int first = 1, int last = 48) {
  try {
    parse_frame_range(text, first, last);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "";
}

TEST(ExitCode, IsAsTheManualSaysForEveryKind) {
  EXPECT_EQ(exit_code_of(ErrorKind::kFailed), 1);
  EXPECT_EQ(exit_code_of(ErrorKind::kBadInput), 3);
  EXPECT_EQ(exit_code_of(ErrorKind::kUnsupported), 3);
  EXPECT_EQ(exit_code_of(ErrorKind::kIo), 4);
  EXPECT_EQ(exit_code_of(ErrorKind::kInterrupted), 130);
}

TEST(ExitCode, WhatIsAskedForAndNotSupportedIsWrongUsage) {
  const auto refuse = [](ErrorKind kind) { as_asked([&]() -> int { throw Error(kind, "a.xyz", "no such kind"); }); };
  EXPECT_THROW(refuse(ErrorKind::kUnsupported), ArgumentError);
  try {
    refuse(ErrorKind::kIo);
  } catch (const ArgumentError&) {
    ADD_FAILURE() << "an error of the disk is no wrong usage";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
  }
  EXPECT_EQ(as_asked([] { return 7; }), 7);
}

TEST(FrameRange, KnowsEveryForm) {
  EXPECT_EQ(parse_frame_range("7", 1, 48), Frames({7}));
  EXPECT_EQ(parse_frame_range("3-6", 1, 48), Frames({3, 4, 5, 6}));
  EXPECT_EQ(parse_frame_range("1-8x3", 1, 48), Frames({1, 4, 7}));
  EXPECT_EQ(parse_frame_range("46-", 1, 48), Frames({46, 47, 48}));
  EXPECT_EQ(parse_frame_range("40-x4", 1, 48), Frames({40, 44, 48}));
  EXPECT_EQ(parse_frame_range("1,5,9-12", 1, 48), Frames({1, 5, 9, 10, 11, 12}));
  EXPECT_EQ(parse_frame_range("0-1", 0, 1), Frames({0, 1}));
}

TEST(FrameRange, SortsAndKeepsEachFrameOnce) {
  EXPECT_EQ(parse_frame_range("9,3-5,4-6,3", 1, 48), Frames({3, 4, 5, 6, 9}));
}

TEST(FrameRange, StrideSharesOfAFarmAddUpToTheWhole) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 engine(seed);
  for (int trial = 0; trial < 50; ++trial) {
    const int last = 1 + static_cast<int>(engine() % 60);
    const int machines = 1 + static_cast<int>(engine() % static_cast<unsigned>(last));
    std::string shares;
    for (int i = 0; i < machines; ++i) {
      if (i > 0) shares += ",";
      shares += std::to_string(1 + i);
      shares += "-x";
      shares += std::to_string(machines);
    }
    EXPECT_EQ(parse_frame_range(shares, 1, last), parse_frame_range("1-", 1, last)) << shares;
  }
}

TEST(FrameRange, RefusesWhatIsNotARange) {
  for (const std::string text : {"", ",", "1,", ",1", "a", "1-b", "-5", "1--5", "1-5x", "1-5y2", "1 - 5", "1.5", "x2",
                                 "1-5x-1", "1-5x2x2", "99999999999"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

TEST(FrameRange, RefusesFramesThatDoNotExistWithoutListingThemFirst) {
  EXPECT_NE(refusal("1-2000000000").find("the frames are 1-48"), std::string::npos);
  EXPECT_NE(refusal("0").find("frame 0 does not exist"), std::string::npos);
  EXPECT_NE(refusal("49-").find("frame 49 does not exist"), std::string::npos);
}

TEST(FrameRange, RefusesBackwardsRangesAndStepZero) {
  EXPECT_NE(refusal("9-3").find("write 3-9"), std::string::npos);
  EXPECT_NE(refusal("1-9x0").find("step"), std::string::npos);
}

TEST(Suggest, FindsTheNearestAndNothingFar) {
  const std::vector<std::string> names = {"morph", "map", "compare", "--overwrite"};
  EXPECT_EQ(nearest("morhp", names), "morph");
  EXPECT_EQ(nearest("mrph", names), "morph");
  EXPECT_EQ(nearest("comparee", names), "compare");
  EXPECT_EQ(nearest("--overwritte", names), "--overwrite");
  EXPECT_EQ(nearest("render", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest("morph", std::vector<std::string>()), std::nullopt);
}

TEST(Report, PrintsEveryKindInTheOrderSet) {
  Report report;
  report.set("z", 1).set("a", true).set("text", "q\"\n").set("none", nullptr).set("half", 0.5);
  report.set("list", Report::array().push(1).push(Report())).set("empty", Report::array());
  EXPECT_EQ(report.to_json(),
            "{\n  \"z\": 1,\n  \"a\": true,\n  \"text\": \"q\\\"\\n\",\n  \"none\": null,\n  \"half\": 0.5,\n"
            "  \"list\": [\n    1,\n    {}\n  ],\n  \"empty\": []\n}");
}

TEST(Report, SurvivesWhatJsonCannotSay) {
  EXPECT_EQ(Report(std::numeric_limits<double>::infinity()).to_json(), "null");
  EXPECT_EQ(Report(std::string("\xff")).to_json(), "\"\xEF\xBF\xBD\"");
}

TEST(Wrapped, BreaksAtSpacesAndKeepsLongWords) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("extraordinary word", 4), "extraordinary\nword");
  EXPECT_EQ(wrapped("a\nb\n", 10), "a\nb\n");
  EXPECT_EQ(wrapped("", 10), "");
}

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
