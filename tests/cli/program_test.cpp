// Tests cli/main.cpp, cli/render_main.cpp, cli/command_line.cpp, cli/command.cpp, cli/command_shape.cpp,
// cli/cmd_help.cpp, cli/cmd_schema.cpp, cli/works.cpp and cli/interrupt.cpp. The frame around all commands, as a person
// or a script meets it.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "morph/media/image_file.h"
#include "tests/cli/commands.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

TEST(Frame, WithoutArgumentsThereIsHelp) {
  const RunResult result = run_morphkit({});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, run_morphkit({"--help"}).out);
  EXPECT_EQ(result.out, run_morphkit({"help"}).out);
  EXPECT_TRUE(contains(result.out, "Example"));
  EXPECT_EQ(result.err, "");
}

TEST(Frame, EveryCommandHasHelpWithAnExampleOfItself) {
  for (const cli::CommandShape& command : cli::program_shape().commands) {
    const RunResult result = run_morphkit({command.name, "--help"});
    EXPECT_EQ(result.exit_code, 0) << command.name;
    EXPECT_EQ(result.err, "") << command.name;
    const std::size_t example = result.out.find("Example:");
    ASSERT_NE(example, std::string::npos) << command.name;
    EXPECT_NE(result.out.find("morphkit " + command.name, example), std::string::npos) << command.name;
    EXPECT_EQ(result.out, run_morphkit({"help", command.name}).out);
    EXPECT_TRUE(contains(run_morphkit({}).out, "  " + command.name)) << command.name;
  }
}

TEST(Frame, TellsItsVersion) {
  const RunResult result = run_morphkit({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("morphkit ")) << result.out;
}

TEST(Frame, SuggestsTheCommandThatWasMeant) {
  expect_usage_error(run_morphkit({"compair", "a", "b"}), "unknown command 'compair'; did you mean 'compare'?");
  expect_usage_error(run_morphkit({"help", "inof"}), "did you mean 'info'?");
  expect_usage_error(run_morphkit({"xyzzy"}), "unknown command 'xyzzy'");
}

TEST(Frame, AFileThatLooksLikeAnOptionIsExplained) {
  const TemporaryFolder folder;
  media::write_image(folder / "-dash.png", warp::Image(3, 4, {0, 0, 0, 1}));
  RunOptions options;
  options.folder = folder.path();
  const RunResult refused = run_morphkit({"info", "-dash.png"}, options);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(contains(refused.err, "'-dash.png' is a file: write ./-dash.png, or put -- before the files."))
      << refused.err;
  EXPECT_EQ(run_morphkit({"info", "--", "-dash.png"}, options).exit_code, 0);
  EXPECT_FALSE(contains(run_morphkit({"info", "-nothing"}, options).err, "is a file"));
}

TEST(Frame, ShowsHowToRenderWhenGivenAProjectAlone) {
  expect_usage_error(run_morphkit({"pair.json"}), "morphkit morph pair.json -o");
}

TEST(Frame, EveryCommandRefusesAnUnknownOptionAndSuggestsTheNearest) {
  for (const cli::CommandShape& command : cli::program_shape().commands) {
    expect_usage_error(run_morphkit({command.name, "--quite"}), "unknown option '--quite'; did you mean '--quiet'?");
    expect_usage_error(run_morphkit({command.name, "--zzzzzz=3"}), command.name + ": unknown option '--zzzzzz'");
  }
}

TEST(Frame, CommonOptionsStandBeforeOrAfterTheCommand) {
  TemporaryFolder folder;
  const std::string file = write_gradient(folder, "a.png");
  EXPECT_EQ(run_morphkit({"-q", "-j", "1", "info", file}).exit_code, 0);
  EXPECT_EQ(run_morphkit({"info", file, "-q", "--threads", "2"}).exit_code, 0);
}

TEST(Frame, RefusesAThreadCountThatIsNone) {
  expect_usage_error(run_morphkit({"-j", "many"}), "many");
  expect_usage_error(run_morphkit({"-j", "-1"}), "-1");
  expect_usage_error(run_morphkit({"--threads"}), "--threads");
}

TEST(Frame, AnOutputThatCannotBeWrittenIsAnError) {
  RunOptions full;
  full.output_to = "/dev/full";
  const RunResult result = run_morphkit({"--help"}, full);
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.err, "standard output: cannot write")) << result.err;

  RunOptions closed;
  closed.close_output = true;
  EXPECT_EQ(run_morphkit({"schema"}, closed).exit_code, 4);
}

TEST(Frame, ClosedOutputDoesNotEndInAFile) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  RunOptions closed;
  closed.close_output = true;
  const std::string difference = (folder / "d.png").string();
  EXPECT_EQ(run_morphkit({"compare", a, b, "--difference", difference}, closed).exit_code, 4);
  EXPECT_EQ(media::read_picture(difference).image.size(), cv::Size(40, 30)) << "the picture holds no message";
}

TEST(Frame, ASignalStopsTheWorkCleanly) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    TemporaryFolder folder;
    RunOptions options;
    options.marker = "frames";
    options.send = signal_number;
    const RunResult result = run_morphkit({"morph", write_gradient(folder, "a.png"), write_gradient(folder, "b.png"),
                                           "-n", "1000000", "-o", (folder / "frame.####.png").string()},
                                          options);
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_TRUE(contains(result.err, "interrupted")) << result.err;
    EXPECT_TRUE(fs::exists(folder / "frame.0001.png"));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
      EXPECT_EQ(entry.path().filename().string().front() == '.', false) << entry.path();
    }
  }
}

TEST(Schema, IsOneJsonObjectOfTheDraftItNames) {
  const RunResult result = run_morphkit({"schema"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("{"));
  EXPECT_TRUE(result.out.ends_with("}\n"));
  EXPECT_TRUE(contains(result.out, "https://json-schema.org/draft/2020-12/schema"));
  expect_usage_error(run_morphkit({"schema", "x"}), "unexpected argument 'x'");
}

TEST(Documentation, NamesEveryCommandAndEveryOptionInItsSection) {
  const std::string text = read_text(MORPHKIT_COMMANDS_PAGE);
  ASSERT_FALSE(text.empty()) << MORPHKIT_COMMANDS_PAGE;
  const cli::CommandShape program = cli::program_shape();
  for (const std::string& name : cli::option_names(program)) EXPECT_TRUE(contains(text, "`" + name)) << name;
  for (const cli::CommandShape& command : program.commands) {
    const std::size_t begin = text.find("\n## " + command.name + "\n");
    ASSERT_NE(begin, std::string::npos) << command.name;
    const std::string section = text.substr(begin, text.find("\n## ", begin + 1) - begin);
    const std::vector<std::string> common = cli::option_names(program);
    for (const std::string& name : cli::option_names(command)) {
      if (std::find(common.begin(), common.end(), name) != common.end()) continue;
      EXPECT_TRUE(contains(section, name)) << command.name << " " << name;
    }
  }
}

}  // namespace
}  // namespace morphkit::test
