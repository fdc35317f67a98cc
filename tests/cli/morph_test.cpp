// Tests cli/cmd_morph.cpp, cli/run_morph.cpp, cli/cmd_check.cpp, cli/run_check.cpp, cli/cmd_map.cpp and
// cli/run_map.cpp. morph, check and map as a person, a script or a render farm meets them, wrong use and disasters
// included.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>

#include <sys/mount.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "warp/image/compare.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

/// A folder with two pictures of different size and a project, 12 frames of 64x48.
class Morph : public testing::Test {
 protected:
  Morph() {
    write_picture("a.png", {64, 48}, {1, 0.2f, 0, 1});
    write_picture("b.png", {50, 70}, {0, 0.3f, 1, 1});
    write_text(folder_ / "pair.json", project());
  }

  void write_picture(const std::string& name, cv::Size size, warp::Pixel base) {
    warp::Image image(size);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        image(y, x) = {base[0] * static_cast<float>(x) / 64, base[1], base[2] * static_cast<float>(y) / 70, 1};
    media::WriteOptions options;
    options.overwrite = true;
    media::write_image(folder_ / name, image, options);
  }

  static std::string project(const std::string& more = "") {
    return R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"}, "features": [)"
           R"({"id": "eye", "line": {"source": [[10, 12], [30, 13]], "destination": [[12, 20], [30, 24]]}},)"
           R"({"id": "nose", "point": {"source": [40, 30], "destination": [30, 40]}}],)"
           R"("output": {"frames": 12})" +
           more + "}";
  }

  RunResult run(std::vector<std::string> arguments, RunOptions options = {}) {
    options.folder = folder_.path();
    return run_morphkit(arguments, options);
  }

  /// Names of the files in the folder that begin with `prefix`, hidden ones too.
  std::vector<std::string> files(const std::string& prefix) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (entry.path().filename().string().starts_with(prefix)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  static void expect_same(const fs::path& a, const fs::path& b) {
    EXPECT_TRUE(read_text(a) == read_text(b)) << a << " and " << b << " differ";
  }

  void expect_error(const RunResult& result, int code, const std::vector<std::string>& parts) {
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.signal, 0);
    for (const std::string& part : parts) EXPECT_TRUE(contains(result.err, part)) << part << " in: " << result.err;
    EXPECT_TRUE(files("out").empty()) << "wrote " << files("out").front();
    EXPECT_TRUE(files(".").empty()) << "left " << files(".").front();
  }

  TemporaryFolder folder_;
};

TEST_F(Morph, RendersFramesFromAProject) {
  const RunResult result = run({"morph", "pair.json", "-o", "out.%03d.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(files("out").size(), 12u);
  EXPECT_EQ(files("out").front(), "out.001.png");
  EXPECT_TRUE(files(".").empty());
  // The first frame is the source, bit for bit: same size, 8 bits.
  EXPECT_EQ(run({"compare", "a.png", "out.001.png"}).exit_code, 0);
}

TEST_F(Morph, TwoPicturesWithFeaturesAreTheSameAsAProject) {
  EXPECT_EQ(run({"morph", "pair.json", "-n", "3", "-o", "one.####.png"}).exit_code, 0);
  const RunResult result = run({"morph", "a.png", "b.png", "--features", "pair.json", "-n", "3", "-o", "two.####.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_same(folder_ / "one.0002.png", folder_ / "two.0002.png");
}

TEST_F(Morph, WithoutFeaturesDissolvesAndSaysHowToMarkThem) {
  const RunResult result = run({"morph", "a.png", "b.png", "-n", "2", "-o", "out.####.png"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.err, "no features")) << result.err;
  EXPECT_TRUE(contains(result.err, "morphkit edit")) << result.err;
}

TEST_F(Morph, AnyChunkingAndAnyThreadsGiveTheSameBytes) {
  EXPECT_EQ(run({"morph", "pair.json", "-o", "whole.%02d.png", "-j", "2"}).exit_code, 0);
  EXPECT_EQ(run({"morph", "pair.json", "-o", "chunk.%02d.png", "-j", "1", "--frames", "7-"}).exit_code, 0);
  EXPECT_EQ(run({"morph", "pair.json", "-o", "chunk.%02d.png", "-j", "5", "--frames", "1,3,5,2-6x2"}).exit_code, 0);
  ASSERT_EQ(files("chunk").size(), 12u);
  for (const std::string& name : files("chunk")) expect_same(folder_ / name, folder_ / ("whole" + name.substr(5)));
}

TEST_F(Morph, TheExactFieldIsWithinATrifleOfTheAdaptive) {
  EXPECT_EQ(run({"morph", "pair.json", "-t", "0.5", "-o", "adaptive.png"}).exit_code, 0);
  EXPECT_EQ(run({"morph", "pair.json", "-t", "0.5", "-o", "exact.png", "--field", "exact"}).exit_code, 0);
  // A fiftieth of a pixel of pictures that change by a sixtieth per pixel.
  const RunResult result = run({"compare", "adaptive.png", "exact.png", "--tolerance", "0.01"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
}

TEST_F(Morph, FiltersAreToldApart) {
  for (const char* filter : {"nearest", "bilinear", "bicubic", "area", "mitchell", "lanczos"}) {
    const std::string file = std::string(filter) + ".png";
    EXPECT_EQ(run({"morph", "pair.json", "-t", "0.5", "-o", file, "--filter", filter}).exit_code, 0) << filter;
  }
  EXPECT_NE(read_text(folder_ / "nearest.png"), read_text(folder_ / "bilinear.png"));
  EXPECT_NE(read_text(folder_ / "bilinear.png"), read_text(folder_ / "bicubic.png"));
}

TEST_F(Morph, SetIsWhatTheShortOptionsAreShortFor) {
  const auto rendered = [&](const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"morph", "pair.json", "-t", "0.5", "-o", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_text(folder_ / file);
  };
  EXPECT_EQ(rendered("short.png", {"--filter", "nearest", "--size", "32x24", "--fit", "contain"}),
            rendered("set.png",
                     {"--set", "warp.filter=nearest", "--set", "output.size=[32, 24]", "--set", "output.fit=contain"}));
  EXPECT_NE(rendered("moved.png", {"--set", "features/nose.point.source=[20, 10]"}), rendered("plain.png", {}));
  EXPECT_EQ(run({"check", "pair.json", "--set", "features/nose.point.source=[900, 30]"}).exit_code, 5);
}

TEST_F(Morph, AMomentIsOnePicture) {
  EXPECT_EQ(run({"morph", "pair.json", "-t", "0", "-o", "moment.tif"}).exit_code, 0);
  EXPECT_EQ(run({"compare", "moment.tif", "a.png"}).exit_code, 0);
}

TEST_F(Morph, ReportsInJson) {
  const RunResult result = run({"morph", "pair.json", "-n", "2", "-o", "out.####.png", "--json", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.out, "\"frames\": 2")) << result.out;
  EXPECT_EQ(result.err, "");
}

TEST_F(Morph, WritesEveryKindOfVideo) {
  for (const std::string kind : {"mp4", "webm", "mkv", "mov", "gif", "apng"}) {
    const RunResult result = run({"morph", "pair.json", "-n", "4", "-o", "film." + kind});
    EXPECT_EQ(result.exit_code, 0) << kind << ": " << result.err;
    EXPECT_GT(fs::file_size(folder_ / ("film." + kind)), 100u);
  }
}

TEST_F(Morph, CompressionAndPresetsChangeTheSize) {
  const auto size_of = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"morph", "pair.json", "-o", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return fs::file_size(folder_ / name);
  };
  EXPECT_GT(size_of("none.png", {"-t", "0.5", "--compression", "0"}), size_of("usual.png", {"-t", "0.5"}));
  EXPECT_NE(size_of("quick.mp4", {"--preset", "ultrafast"}), size_of("slow.mp4", {"--preset", "slow"}));
}

TEST_F(Morph, KeepsWhatExists) {
  write_text(folder_ / "kept.0002.png", "precious");
  const RunResult result = run({"morph", "pair.json", "-o", "kept.####.png"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.err, "kept.0002.png: exists")) << result.err;
  EXPECT_TRUE(contains(result.err, "--overwrite")) << result.err;
  EXPECT_EQ(files("kept").size(), 1u);
  EXPECT_EQ(read_text(folder_ / "kept.0002.png"), "precious");
  EXPECT_EQ(run({"morph", "pair.json", "-o", "kept.####.png", "--overwrite"}).exit_code, 0);
  EXPECT_NE(read_text(folder_ / "kept.0002.png"), "precious");
}

TEST_F(Morph, ResumeCompletesToTheSameBytes) {
  EXPECT_EQ(run({"morph", "pair.json", "-o", "whole.%02d.png"}).exit_code, 0);
  EXPECT_EQ(run({"morph", "pair.json", "-o", "part.%02d.png", "--frames", "2-5"}).exit_code, 0);
  write_text(folder_ / "part.07.png", "");  // not a frame
  const RunResult result = run({"morph", "pair.json", "-o", "part.%02d.png", "--resume"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "4 were there already")) << result.err;
  for (const std::string& name : files("whole")) expect_same(folder_ / name, folder_ / ("part" + name.substr(5)));
}

TEST_F(Morph, ResumeRendersDamagedFramesAnew) {
  for (const std::string kind : {"png", "exr", "tif", "jpg", "tga", "webp"}) {
    const std::string pattern = "part.%02d." + kind;
    EXPECT_EQ(run({"morph", "pair.json", "-o", pattern}).exit_code, 0);
    const std::string whole = read_text(folder_ / ("part.05." + kind));
    write_text(folder_ / ("part.05." + kind), whole.substr(0, whole.size() * 2 / 3));
    const RunResult result = run({"morph", "pair.json", "-o", pattern, "--resume"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "1 of 12 frames were damaged")) << kind << ": " << result.err;
    EXPECT_TRUE(contains(result.err, "11 were there already")) << kind << ": " << result.err;
    EXPECT_EQ(read_text(folder_ / ("part.05." + kind)), whole) << kind;
  }
}

TEST_F(Morph, ResumeRendersFramesOfAnotherProjectAnew) {
  EXPECT_EQ(run({"morph", "pair.json", "-o", "part.%02d.png"}).exit_code, 0);
  const auto renewed = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"morph", "pair.json", "-o", "part.%02d.png", "--resume"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return contains(result.err, "12 of 12 frames were damaged or made from something else: rendered anew");
  };
  EXPECT_FALSE(renewed({}));
  EXPECT_TRUE(renewed({"--set", "features/nose.point.source=[20, 10]"}));
  EXPECT_TRUE(renewed({}));
  EXPECT_TRUE(renewed({"--compression", "6"}));
  EXPECT_TRUE(renewed({"--depth", "16"}));
  write_picture("a.png", {64, 48}, {0.5f, 0.2f, 0, 1});
  EXPECT_TRUE(renewed({"--depth", "16"}));
  EXPECT_FALSE(renewed({"--depth", "16", "--threads", "1"}));
}

TEST_F(Morph, ResumeDoesNotMindWhereThePicturesLie) {
  EXPECT_EQ(run({"morph", "pair.json", "-o", "part.%02d.png"}).exit_code, 0);
  fs::rename(folder_ / "a.png", folder_ / "moved.png");
  const RunResult result =
      run({"morph", "pair.json", "-o", "part.%02d.png", "--resume", "--set", "source.image=moved.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "12 were there already")) << result.err;
}

TEST_F(Morph, ResumeLeavesACompleteVideoAlone) {
  for (const std::string name : {"film.mp4", "film.webm", "film.mkv", "film.mov"}) {
    const auto resumed = [&](const std::string& what) {
      const RunResult result = run({"morph", "pair.json", "-o", name, "--resume"});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_TRUE(contains(result.err, what)) << name << ": " << result.err;
    };
    EXPECT_EQ(run({"morph", "pair.json", "-o", name, "--frames", "1-4"}).exit_code, 0);
    resumed("12 of 12 frames were damaged or made from something else");
    const std::string whole = read_text(folder_ / name);
    resumed("12 were there already");
    EXPECT_EQ(read_text(folder_ / name), whole);
    write_text(folder_ / name, whole.substr(0, whole.size() * 4 / 5));
    resumed("12 of 12 frames were damaged");
    EXPECT_EQ(read_text(folder_ / name), whole) << name;
  }
}

TEST_F(Morph, AnInterruptFinishesFramesInWorkAndResumes) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    for (const std::string& name : files("part")) fs::remove(folder_ / name);
    RunOptions options;
    options.marker = "frames/s";
    options.send = signal;
    const RunResult result =
        run({"morph", "pair.json", "--size", "640x480", "-n", "60", "-o", "part.%02d.png"}, options);
    if (signal == SIGKILL) {
      EXPECT_EQ(result.signal, SIGKILL);
    } else {
      EXPECT_EQ(result.exit_code, 130) << result.err;
      EXPECT_TRUE(contains(result.err, "interrupted")) << result.err;
      EXPECT_TRUE(files(".").empty());
    }
    const std::vector<std::string> finished = files("part");
    EXPECT_LT(finished.size(), 60u);
    for (const std::string& name : finished) EXPECT_NO_THROW(media::read_picture(folder_ / name)) << name;
    const RunResult rest =
        run({"morph", "pair.json", "--size", "640x480", "-n", "60", "-o", "part.%02d.png", "--resume"});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(files("part").size(), 60u);
    EXPECT_TRUE(files(".").empty()) << "temporary files are left";
  }
  EXPECT_EQ(run({"morph", "pair.json", "--size", "640x480", "-n", "60", "-o", "whole.%02d.png"}).exit_code, 0);
  for (const std::string& name : files("part")) expect_same(folder_ / name, folder_ / ("whole" + name.substr(4)));
}

TEST_F(Morph, AnInterruptedVideoLeavesNothing) {
  RunOptions options;
  options.marker = "frames/s";
  options.send = SIGINT;
  expect_error(run({"morph", "pair.json", "--size", "640x480", "-n", "200", "-o", "out.mp4"}, options), 130,
               {"interrupted"});
}

TEST_F(Morph, SignalsInOneMomentAreOneRequest) {
  RunOptions options;
  options.marker = "frames/s";
  options.send = SIGTERM;
  options.send_count = 2;  // as `timeout` sends it to a process and to its group
  expect_error(run({"morph", "pair.json", "--size", "640x480", "-n", "200", "-o", "out.mp4"}, options), 130,
               {"interrupted"});
}

TEST_F(Morph, LongSingleWorksStopInTheirMidst) {
  RunOptions options;
  options.marker = "canvas ";
  options.send = SIGTERM;
  const std::vector<std::vector<std::string>> works = {{"check"},
                                                       {"map", "-t", "0.5", "-o", "big.exr"},
                                                       {"map", "--frames", "1-12", "-o", "big.##.exr"},
                                                       {"morph", "-t", "0.5", "-o", "big.png"}};
  for (std::vector<std::string> arguments : works) {
    arguments.insert(arguments.begin() + 1, "pair.json");
    arguments.insert(arguments.end(), {"--verbose", "--set", "output.size=[4000, 4000]"});
    const RunResult result = run(arguments, options);
    EXPECT_EQ(result.exit_code, 130) << arguments.front() << ": " << result.err;
    EXPECT_TRUE(contains(result.err, "interrupted")) << result.err;
    EXPECT_TRUE(files("big").empty());
    EXPECT_TRUE(files(".").empty());
  }
}

TEST_F(Morph, AVideoNeedsFfmpegAndSaysSo) {
  RunOptions options;
  options.environment = {"PATH=/nowhere"};
  expect_error(run({"morph", "pair.json", "-o", "out.mp4"}, options), 4, {"ffmpeg", "frame"});
}

TEST_F(Morph, RefusesWrongUse) {
  expect_error(run({"morph", "pair.json"}), 2, {"--output"});
  expect_error(run({"morph", "-o", "out.mp4"}), 2, {"PROJECT"});
  expect_error(run({"morph", "a.png", "-o", "out.mp4"}), 2, {"a.png", "two pictures"});
  expect_error(run({"morph", "pair.json", "-o", "out.xyz"}), 2, {"out.xyz", ".mp4"});
  expect_error(run({"morph", "pair.json", "-o", "out.png"}), 2, {"out.png", "%04d"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.%d.png"}), 2, {"out.%d.%d.png"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--frames", "0-5"}), 2, {"0"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--frames", "5-x"}), 2, {"5-x"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--size", "640"}), 2, {"640", "1280x720"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--size", "40000x40000"}), 2,
               {"--size", "40000x40000", "too large", "65536"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--fps", "fast"}), 2, {"fast", "30000/1001"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--fit", "squash"}), 2, {"squash"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--filter", "sharp"}), 2, {"--filter", "sharp"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--field", "rough"}), 2, {"--field", "rough"});
  expect_error(run({"morph", "pair.json", "-o", "out.png", "-t", "2"}), 2, {"2"});
  expect_error(run({"morph", "pair.json", "-o", "out.png", "-t", "nan"}), 2, {"nan"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--depth", "12"}), 2, {"12"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.jpg", "--depth", "16"}), 2, {"jp"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.jpg", "--compression", "5"}), 2, {"JPEG", "PNG"});
  expect_error(run({"morph", "pair.json", "-o", "out.mp4", "--compression", "5"}), 2, {".mp4", "PNG"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--compression", "10"}), 2, {"--compression", "10"});
  expect_error(run({"morph", "pair.json", "-o", "out.mp4", "--preset", "good"}), 2, {"good", "veryfast"});
  expect_error(run({"morph", "pair.json", "-o", "out.%d.png", "--preset", "fast"}), 2, {".mp4 and .webm"});
  expect_error(run({"morph", "pair.json", "-o", "out.png", "-t", "0.5", "--preset", "fast"}), 2, {".mp4 and .webm"});
  expect_error(run({"morph", "pair.json", "--features", "pair.json", "-o", "out.mp4"}), 2, {"--features"});
  expect_error(run({"morph", "pair.json", "--resume", "--overwrite", "-o", "out.%d.png"}), 2, {"--resume"});
}

TEST_F(Morph, RefusesBadProjects) {
  const auto bad = [&](const std::string& text, const std::vector<std::string>& parts) {
    write_text(folder_ / "bad.json", text);
    expect_error(run({"morph", "bad.json", "-o", "out.mp4"}), 3, parts);
  };
  bad("", {"bad.json"});
  bad("{", {"bad.json:1"});
  bad(project(R"(, "outptu": {})"), {"bad.json", "outptu", "output"});
  bad(R"({"morphkit": 2})", {"bad.json: /morphkit", "2"});
  bad(std::string(10'000'000, '['), {"bad.json"});
  std::string far = project();
  far.replace(far.find("[10, 12]"), 8, "[1e300, 12]");
  bad(far, {"bad.json: /features/0/line/source/0"});
  std::string one_sided = project();
  one_sided.replace(one_sided.find(R"(, "destination": [30, 40])"), 25, "");
  bad(one_sided, {"bad.json: /features/1", "destination"});
}

TEST_F(Morph, RefusesPicturesThatAreNone) {
  const auto bad = [&](const std::string& name, int code, const std::vector<std::string>& parts) {
    expect_error(run({"morph", name, "b.png", "-o", "out.mp4"}), code, parts);
  };
  bad("missing.png", 4, {"missing.png"});
  fs::create_directory(folder_ / "folder.png");
  bad("folder.png", 4, {"folder.png"});
  write_text(folder_ / "empty.png", "");
  bad("empty.png", 3, {"empty.png"});
  write_text(folder_ / "text.png", "this is no picture");
  bad("text.png", 3, {"text.png"});
  const std::string whole = read_text(folder_ / "a.png");
  write_text(folder_ / "half.png", whole.substr(0, whole.size() / 2));
  bad("half.png", 3, {"half.png"});
  // A header that promises 100000 x 100000 pixels.
  std::string huge = whole;
  huge.replace(16, 8, std::string("\x00\x01\x86\xa0\x00\x01\x86\xa0", 8));
  write_text(folder_ / "huge.png", huge);
  bad("huge.png", 3, {"huge.png"});
}

TEST_F(Morph, SmallestAndNotFinitePicturesRender) {
  write_picture("dot.png", {1, 1}, {1, 1, 1, 1});
  EXPECT_EQ(run({"morph", "dot.png", "b.png", "-n", "3", "-o", "dot.%d.png"}).exit_code, 0);
  EXPECT_EQ(run({"morph", "a.png", "dot.png", "-n", "3", "-o", "to-dot.%d.png"}).exit_code, 0);
  warp::Map nan(8, 8, warp::MapPoint(std::numeric_limits<float>::quiet_NaN(), 0.5f));
  media::write_map(folder_ / "nan.exr", nan, true);
  const RunResult result = run({"morph", "nan.exr", "b.png", "-n", "2", "-o", "nan.%d.exr"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "64 pixels are NaN")) << result.err;
}

TEST_F(Morph, RefusesPlacesItCannotWriteTo) {
  expect_error(run({"morph", "pair.json", "-o", "nowhere/out.%d.png"}), 4, {"nowhere"});
  expect_error(run({"morph", "pair.json", "-o", "nowhere/out.mp4"}), 4, {"nowhere"});
  if (geteuid() == 0) return;  // root may write anywhere
  fs::create_directory(folder_ / "locked");
  fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expect_error(run({"morph", "pair.json", "-o", "locked/out.%d.png"}), 4, {"locked"});
}

TEST_F(Morph, AFullDiskLosesNothingAndSaysSo) {
  const fs::path disk = folder_ / "disk";
  fs::create_directory(disk);
  if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=256k") != 0) GTEST_SKIP() << "a small disk needs root";
  const RunResult frames = run({"morph", "pair.json", "--size", "320x240", "-n", "40", "-o", "disk/f.%02d.tif"});
  std::vector<fs::path> there;
  for (const auto& entry : fs::directory_iterator(disk)) there.push_back(entry.path());
  std::size_t readable = 0;
  for (const fs::path& file : there) readable += media::read_picture(file).image.empty() ? 0 : 1;
  umount(disk.c_str());
  EXPECT_EQ(frames.exit_code, 4) << frames.err;
  EXPECT_TRUE(contains(frames.err, "disk/f.")) << frames.err;
  EXPECT_EQ(readable, there.size());
  EXPECT_LT(there.size(), 40u);
}

TEST_F(Morph, CheckFindsWhatIsWrong) {
  EXPECT_EQ(run({"check", "pair.json"}).exit_code, 0);
  write_text(folder_ / "cross.json",
             R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"}, "features": [)"
             R"({"id": "one", "line": {"source": [[10, 10], [30, 30]], "destination": [[10, 10], [30, 30]]}},)"
             R"({"id": "two", "line": {"source": [[10, 30], [30, 10]], "destination": [[10, 30], [30, 10]]}}]})");
  const RunResult text = run({"check", "cross.json"});
  EXPECT_EQ(text.exit_code, 5);
  EXPECT_TRUE(contains(text.out, "\"one\" and \"two\" cross")) << text.out;
  const RunResult json = run({"check", "cross.json", "--json"});
  EXPECT_EQ(json.exit_code, 5);
  EXPECT_TRUE(contains(json.out, "\"kind\": \"crossing\"")) << json.out;
  EXPECT_EQ(run({"check", "missing.json"}).exit_code, 4);
}

TEST_F(Morph, TellsOfSettingsThatTheMethodDoesNotUse) {
  write_text(folder_ / "mesh.json",
             R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"},)"
             R"("mesh": {"size": [3, 3]}, "warp": {"filter": "lanczos"}})");
  const std::string told = "\"filter\" of \"warp\" is not used, for the method is mesh";
  EXPECT_TRUE(contains(run({"morph", "mesh.json", "-t", "0.5", "-o", "m.png"}).err, told));
  EXPECT_TRUE(contains(run({"map", "mesh.json", "-t", "0.5", "-o", "m.exr"}).err, told));
  EXPECT_TRUE(contains(run({"check", "mesh.json"}).out, told));
  EXPECT_FALSE(contains(run({"morph", "pair.json", "-t", "0.5", "-o", "p.png", "--filter", "lanczos"}).err, told));
}

TEST_F(Morph, MapIsAnSTMap) {
  EXPECT_EQ(run({"map", "pair.json", "-t", "0", "-o", "st.exr"}).exit_code, 0);
  const warp::Image map = media::read_picture(folder_ / "st.exr", media::ColorSpace::kLinear).image;
  ASSERT_EQ(map.size(), cv::Size(64, 48));
  EXPECT_FLOAT_EQ(map(0, 0)[0], 0.5f / 64);
  EXPECT_FLOAT_EQ(map(0, 0)[1], 1 - 0.5f / 48);
  EXPECT_EQ(run({"map", "pair.json", "--frames", "1-3", "--side", "destination", "-o", "st.%d.exr"}).exit_code, 0);
  EXPECT_EQ(files("st.").size(), 4u);
  EXPECT_EQ(run({"map", "pair.json", "-o", "st2.exr"}).exit_code, 2);
  EXPECT_EQ(run({"map", "pair.json", "-t", "0", "-o", "st.exr"}).exit_code, 4);
}

}  // namespace
}  // namespace morphkit::test
