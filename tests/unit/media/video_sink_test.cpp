// Failures while a video is written: nothing is left behind, and the error gives the reason.

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/unit/media/sink_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Environment;
using test::error_of;
using test::has_children;
using test::moving_picture;
using test::read_bytes;
using test::TemporaryFolder;
using test::write_all;

const cv::Size kSize(64, 48);

SinkOptions options() {
  SinkOptions result;
  result.size = kSize;
  return result;
}

/// A program called ffmpeg, first on PATH.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) : path_("PATH", folder_.path().string() + ":" + std::getenv("PATH")) {
    const fs::path program = folder_ / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(program, fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  }

 private:
  TemporaryFolder folder_;
  Environment path_;
};

/// Writes many frames; an ended program is noticed while writing or at the end.
Error failure_of(const fs::path& file) {
  return error_of([&] { write_all(*open_sink(file, options(), false), kSize, 300); });
}

void expect_nothing_left(const TemporaryFolder& folder) {
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
  EXPECT_FALSE(has_children());
}

TEST(VideoFailure, AMissingFfmpegIsReportedWithARemedy) {
  const TemporaryFolder folder;
  const TemporaryFolder empty;
  const Environment path("PATH", empty.path().string());
  for (const char* name : {"out.mp4", "out.gif"}) {
    const Error error = error_of([&] { open_sink(folder / name, options(), false); });
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
    EXPECT_EQ(error.place(), (folder / name).string());
    for (const char* word : {"ffmpeg", "not on PATH", "apt-get install ffmpeg", "frame.%04d.png"})
      EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
  }
  expect_nothing_left(folder);
}

TEST(VideoFailure, AnFfmpegThatCannotRunIsReported) {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  std::ofstream(programs / "ffmpeg") << "not executable";
  const Environment path("PATH", programs.path().string());
  const Error error = error_of([&] { open_sink(folder / "out.mp4", options(), false); });
  EXPECT_EQ(error.kind(), ErrorKind::kIo);
  EXPECT_NE(error.message().find("cannot be started: Permission denied"), std::string::npos) << error.message();
  expect_nothing_left(folder);
}

TEST(VideoFailure, AnFfmpegThatDiesAtOnceIsQuoted) {
  const TemporaryFolder folder;
  const FakeFfmpeg fake("echo 'Unknown encoder libx264' >&2; exit 3");
  const Error error = failure_of(folder / "out.mp4");
  EXPECT_EQ(error.kind(), ErrorKind::kFailed);
  EXPECT_EQ(error.place(), (folder / "out.mp4").string());
  EXPECT_NE(error.message().find("ended with status 3"), std::string::npos) << error.message();
  EXPECT_NE(error.message().find("Unknown encoder libx264"), std::string::npos) << error.message();
  expect_nothing_left(folder);
}

TEST(VideoFailure, AnFfmpegThatDiesInTheMiddleIsQuoted) {
  const TemporaryFolder folder;
  const FakeFfmpeg fake("head -c 100000 > /dev/null; echo 'half way' >&2; kill -9 $$");
  const Error error = failure_of(folder / "out.mkv");
  EXPECT_EQ(error.kind(), ErrorKind::kFailed);
  EXPECT_NE(error.message().find("ended by signal 9"), std::string::npos) << error.message();
  EXPECT_NE(error.message().find("half way"), std::string::npos) << error.message();
  expect_nothing_left(folder);
}

TEST(VideoFailure, AnFfmpegThatClosesItsInputAndSaysNothing) {
  const TemporaryFolder folder;
  const FakeFfmpeg fake("exec 0<&-; exit 0");
  const Error error = failure_of(folder / "out.webm");
  EXPECT_EQ(error.kind(), ErrorKind::kFailed);
  expect_nothing_left(folder);
}

TEST(VideoFailure, AnFfmpegThatWritesNothingIsAFailure) {
  const TemporaryFolder folder;
  const FakeFfmpeg fake("cat > /dev/null");
  const Error error = failure_of(folder / "out.webm");
  EXPECT_EQ(error.kind(), ErrorKind::kFailed);
  EXPECT_NE(error.message().find("written nothing"), std::string::npos) << error.message();
  expect_nothing_left(folder);
}

TEST(VideoFailure, AFullDiskIsAnInputOutputError) {
  const TemporaryFolder folder;
  const FakeFfmpeg fake("cat > /dev/null; echo 'Error writing trailer: No space left on device' >&2; exit 1");
  const Error error = failure_of(folder / "out.mp4");
  EXPECT_EQ(error.kind(), ErrorKind::kIo);
  EXPECT_NE(error.message().find("No space left on device"), std::string::npos) << error.message();
  expect_nothing_left(folder);
}

TEST(VideoFailure, ARealFfmpegThatCannotWriteIsNoticed) {
  const TemporaryFolder folder;
  // An inherited limit on the size of files acts as a full disk: write() fails with EFBIG.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{4096, before.rlim_max};
  const auto previous = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  for (const char* name : {"o.mp4", "o.webm", "o.mkv", "o.mov", "o.gif", "o.apng"}) {
    const Error error = failure_of(folder / name);
    EXPECT_EQ(error.kind(), ErrorKind::kFailed) << name;
    EXPECT_NE(error.message().find("File too large"), std::string::npos) << error.message();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, previous);
  expect_nothing_left(folder);
}

TEST(VideoFailure, WithoutFinishNothingIsLeft) {
  const TemporaryFolder folder;
  for (const char* name : {"o.mp4", "o.webm", "o.mkv", "o.mov", "o.gif", "o.apng"}) {
    const auto sink = open_sink(folder / name, options(), false);
    for (int frame = 0; frame < 5; ++frame) sink->write(frame, sink->encode(frame, moving_picture(kSize, frame)));
    EXPECT_FALSE(fs::exists(folder / name)) << "not before it is complete";
  }
  expect_nothing_left(folder);
}

TEST(VideoFailure, WithoutFinishTheOldVideoStays) {
  const TemporaryFolder folder;
  std::ofstream(folder / "o.mp4") << "old";
  SinkOptions overwriting = options();
  overwriting.image.overwrite = true;
  {
    const auto sink = open_sink(folder / "o.mp4", overwriting, false);
    EXPECT_EQ(sink->existing({0, 1}), std::vector<fs::path>{folder / "o.mp4"});
    sink->write(0, sink->encode(0, moving_picture(kSize, 0)));
  }
  EXPECT_EQ(read_bytes(folder / "o.mp4").size(), 3U);
  write_all(*open_sink(folder / "o.mp4", overwriting, false), kSize, 3);
  EXPECT_GT(fs::file_size(folder / "o.mp4"), 100U);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(VideoFailure, WithoutOverwriteAnExistingVideoIsRefusedAtOnce) {
  const TemporaryFolder folder;
  std::ofstream(folder / "o.mp4") << "old";
  const Error error = error_of([&] { open_sink(folder / "o.mp4", options(), false); });
  EXPECT_EQ(error.kind(), ErrorKind::kIo);
  EXPECT_NE(std::string(error.what()).find("o.mp4"), std::string::npos);
  EXPECT_EQ(read_bytes(folder / "o.mp4").size(), 3U);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(VideoFailure, NoFramesMakeNoVideo) {
  const TemporaryFolder folder;
  const Error error = error_of([&] { open_sink(folder / "o.mp4", options(), false)->finish(); });
  EXPECT_EQ(error.kind(), ErrorKind::kFailed);
  expect_nothing_left(folder);
}

TEST(VideoFailure, ImpossibleOptionsAreRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const char* name, int num, int den, int quality) {
    SinkOptions how = options();
    how.fps_num = num;
    how.fps_den = den;
    how.video_quality = quality;
    const Error error = error_of([&] { open_sink(folder / name, how, false); });
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported);
    return error.message();
  };
  EXPECT_NE(refusal("o.mp4", 24, 1, 52).find("0 (best) to 51"), std::string::npos);
  EXPECT_NE(refusal("o.webm", 24, 1, 64).find("0 (best) to 63"), std::string::npos);
  EXPECT_NE(refusal("o.gif", 60, 1, -1).find("at most 50"), std::string::npos);
  EXPECT_NE(refusal("o.mp4", 0, 1, -1).find("0/1"), std::string::npos);
  EXPECT_NE(refusal("o.mkv", 24, 0, -1).find("24/0"), std::string::npos);
  expect_nothing_left(folder);
}

TEST(VideoFailure, AFrameOfAnotherSizeIsABrokenContract) {
  const TemporaryFolder folder;
  const auto sink = open_sink(folder / "o.mp4", options(), false);
  EXPECT_THROW(sink->encode(0, moving_picture({63, 48}, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace morphkit::media
