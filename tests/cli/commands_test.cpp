// The simple commands and the frame around all of them, as a person or a script meets them.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "warp/image/color.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

warp::Image gradient(cv::Size size) {
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float r = warp::linear_from_srgb(static_cast<float>((x * 7) % 256) / 255);
      const float g = warp::linear_from_srgb(static_cast<float>((y * 5) % 256) / 255);
      image(y, x) = {r, g, 0.5F * (r + g), 1};
    }
  }
  return image;
}

/// A PNG of 40x30 and its text name.
std::string write_gradient(const TemporaryFolder& folder, const std::string& name, cv::Size size = {40, 30}) {
  media::write_image(folder / name, gradient(size));
  return (folder / name).string();
}

/// The gradient with the red of pixel (11, 7) changed by one step of 8 bits.
std::string write_changed(const TemporaryFolder& folder, const std::string& name) {
  warp::Image image = gradient({40, 30});
  image(7, 11)[0] = warp::linear_from_srgb(78.0F / 255);
  media::write_image(folder / name, image);
  return (folder / name).string();
}

void expect_usage_error(const RunResult& result, const std::string& message) {
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_TRUE(contains(result.err, message)) << result.err;
  EXPECT_EQ(result.out, "");
}

// --- the frame ------------------------------------------------------------------------------------------------------

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

// --- info -----------------------------------------------------------------------------------------------------------

TEST(Info, TellsOfAPicture) {
  TemporaryFolder folder;
  const RunResult result = run_morphkit({"info", write_gradient(folder, "with space.png")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "png, 40x30")) << result.out;
  EXPECT_TRUE(contains(result.out, "sRGB"));
}

TEST(Info, CountsPixelsThatAreNotFinite) {
  TemporaryFolder folder;
  warp::Image image = gradient({8, 8});
  image(3, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  image(4, 3)[1] = std::numeric_limits<float>::infinity();
  media::WriteOptions options;
  options.depth = media::Depth::kFloat;
  media::write_image(folder / "a.exr", image, options);
  const RunResult text = run_morphkit({"info", "--pixels", (folder / "a.exr").string()});
  EXPECT_TRUE(contains(text.out, "not finite   2 pixels")) << text.out << text.err;
  const RunResult json = run_morphkit({"info", "--pixels", "--json", (folder / "a.exr").string()});
  EXPECT_TRUE(contains(json.out, "\"nonfinite_pixels\": 2")) << json.out;
}

TEST(Info, TellsOfAProject) {
  TemporaryFolder folder;
  write_gradient(folder, "a.png");
  write_text(folder / "pair.json", R"({
    "morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "gone.png"},
    "features": [{"id": "n", "point": {"source": [1, 2], "destination": [3, 4]}}],
    "output": {"frames": 30, "fps": 25}})");
  const RunResult result = run_morphkit({"info", (folder / "pair.json").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "a.png, 40x30")) << result.out;
  EXPECT_TRUE(contains(result.out, "gone.png, cannot be read")) << result.out;
  EXPECT_TRUE(contains(result.out, "1 point")) << result.out;
  EXPECT_TRUE(contains(result.out, "frames 1-30 at 25 fps")) << result.out;
}

TEST(Info, ReportsBadFilesAndGoesOn) {
  TemporaryFolder folder;
  const std::string good = write_gradient(folder, "a.png");
  write_text(folder / "text.png", "not a picture");
  write_text(folder / "empty.png", "");
  write_text(folder / "cut.png", read_text(good).substr(0, 20));
  write_text(folder / "bad.json", "{\"morphkit\": 2}");
  const auto code = [&](const std::string& name) { return run_morphkit({"info", (folder / name).string()}).exit_code; };
  EXPECT_EQ(code("text.png"), 3);
  EXPECT_EQ(code("empty.png"), 3);
  EXPECT_EQ(code("cut.png"), 3);
  EXPECT_EQ(code("bad.json"), 3);
  EXPECT_EQ(code("missing.png"), 4);
  EXPECT_EQ(code("missing.json"), 4);
  EXPECT_EQ(run_morphkit({"info", folder.path().string()}).exit_code, 4);

  const RunResult mixed = run_morphkit({"info", (folder / "missing.png").string(), good});
  EXPECT_EQ(mixed.exit_code, 4);
  EXPECT_TRUE(contains(mixed.out, "40x30"));
  EXPECT_TRUE(contains(mixed.err, "missing.png"));
}

TEST(Info, NeedsAFile) {
  expect_usage_error(run_morphkit({"info"}), "FILE is required");
}

// --- compare --------------------------------------------------------------------------------------------------------

TEST(Compare, EqualPicturesAreIdentical) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const RunResult result = run_morphkit({"compare", a, a});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "identical bit for bit")) << result.out;
}

TEST(Compare, NamesTheWorstPixelAndHonoursTheTolerance) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const RunResult result = run_morphkit({"compare", a, b});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.out, "worst pixel       x 11 y 7")) << result.out;
  EXPECT_TRUE(contains(result.out, "1 of 1200")) << result.out;
  EXPECT_EQ(run_morphkit({"compare", a, b, "--tolerance", "0.005"}).exit_code, 0);
  EXPECT_EQ(run_morphkit({"compare", a, b, "--tolerance", "0.003"}).exit_code, 5);
}

TEST(Compare, WritesThePictureOfTheDifferenceAndDoesNotReplaceOne) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const std::string difference = (folder / "d.png").string();
  const std::vector<std::string> command = {"compare", a, b, "--difference", difference, "--gain", "255"};
  EXPECT_EQ(run_morphkit(command).exit_code, 5);
  const warp::Image picture = media::read_picture(difference).image;
  EXPECT_EQ(picture(7, 11), warp::Pixel(1, 0, 0, 1));
  EXPECT_EQ(picture(7, 12), warp::Pixel(0, 0, 0, 1));
  EXPECT_EQ(run_morphkit(command).exit_code, 4);
  std::vector<std::string> again = command;
  again.push_back("-y");
  EXPECT_EQ(run_morphkit(again).exit_code, 5);
}

TEST(Compare, UnequalSizesAreADifference) {
  TemporaryFolder folder;
  const RunResult result =
      run_morphkit({"compare", write_gradient(folder, "a.png"), write_gradient(folder, "b.png", {41, 30})});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.out, "sizes differ")) << result.out;
}

TEST(Compare, NotANumberNeverPasses) {
  TemporaryFolder folder;
  warp::Image image = gradient({8, 8});
  image(0, 0)[2] = std::numeric_limits<float>::quiet_NaN();
  media::WriteOptions options;
  options.depth = media::Depth::kFloat;
  media::write_image(folder / "a.exr", image, options);
  const std::string a = (folder / "a.exr").string();
  const RunResult result = run_morphkit({"compare", a, a, "--tolerance", "1000"});
  EXPECT_EQ(result.exit_code, 5) << result.out;
  EXPECT_TRUE(contains(result.out, "not finite")) << result.out;
}

TEST(Compare, PrintsJson) {
  TemporaryFolder folder;
  const std::string a = write_gradient(folder, "a.png");
  const std::string b = write_changed(folder, "b.png");
  const RunResult same = run_morphkit({"compare", a, a, "--json"});
  EXPECT_TRUE(contains(same.out, "\"identical\": true")) << same.out;
  EXPECT_TRUE(contains(same.out, "\"psnr_db\": null")) << same.out;
  const RunResult other = run_morphkit({"compare", a, b, "--json"});
  EXPECT_EQ(other.exit_code, 5);
  EXPECT_TRUE(contains(other.out, "\"differing_pixels\": 1,")) << other.out;
}

TEST(Compare, RefusesWrongUse) {
  expect_usage_error(run_morphkit({"compare", "a.png"}), "B is required");
  expect_usage_error(run_morphkit({"compare", "a", "b", "c"}), "unexpected argument 'c'");
  expect_usage_error(run_morphkit({"compare", "a", "b", "--tolerance", "-1"}), "'-1' is not a number of at least 0");
  expect_usage_error(run_morphkit({"compare", "a", "b", "--gain", "nan"}), "'nan' is not a number of at least 0");
  EXPECT_EQ(run_morphkit({"compare", "/nonexistent/a.png", "/nonexistent/b.png"}).exit_code, 4);
}

// --- schema, demo, completion ---------------------------------------------------------------------------------------

TEST(Schema, IsOneJsonObjectOfTheDraftItNames) {
  const RunResult result = run_morphkit({"schema"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("{"));
  EXPECT_TRUE(result.out.ends_with("}\n"));
  EXPECT_TRUE(contains(result.out, "https://json-schema.org/draft/2020-12/schema"));
  expect_usage_error(run_morphkit({"schema", "x"}), "unexpected argument 'x'");
}

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

TEST(Completion, BashScriptIsBashAndCompletes) {
  TemporaryFolder folder;
  const fs::path script = folder / "completion.bash";
  write_text(script, run_morphkit({"completion", "bash"}).out);
  EXPECT_EQ(run_program("/bin/bash", {"-n", script.string()}).exit_code, 0);
  const auto complete = [&](const std::string& words, int index) {
    return run_program("/bin/bash", {"-c",
                                     "source \"$0\"; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(index) +
                                         "; _morphkit; echo \"${COMPREPLY[*]}\"",
                                     script.string()})
        .out;
  };
  EXPECT_EQ(complete("morphkit comp", 1), "compare completion\n");
  EXPECT_EQ(complete("morphkit compare --tol", 2), "--tolerance\n");
  EXPECT_EQ(complete("morphkit completion ''", 2), "bash zsh fish\n");
  EXPECT_EQ(complete("morphkit help sch", 2), "schema\n");
}

TEST(Completion, EveryShellKnowsEveryOptionOfEveryCommand) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const RunResult result = run_morphkit({"completion", shell});
    EXPECT_EQ(result.exit_code, 0);
    for (const cli::CommandShape& command : cli::program_shape().commands) {
      EXPECT_TRUE(contains(result.out, command.name)) << shell << command.name;
      for (const std::string& name : cli::option_names(command)) {
        const bool is_long = name.starts_with("--");
        const std::string spelling =
            shell != "fish" ? name : (is_long ? "-l " + name.substr(2) : "-s " + name.substr(1));
        EXPECT_TRUE(contains(result.out, spelling)) << shell << " " << command.name << " " << name;
      }
    }
  }
}

TEST(Completion, RefusesAShellItDoesNotKnow) {
  expect_usage_error(run_morphkit({"completion", "tcsh"}), "bash,zsh,fish");
  expect_usage_error(run_morphkit({"completion"}), "SHELL is required");
}

// --- documentation --------------------------------------------------------------------------------------------------

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
