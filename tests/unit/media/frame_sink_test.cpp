#include <fstream>

#include <gtest/gtest.h>

#include "tests/unit/media/sink_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::moving_picture;
using test::read_bytes;
using test::TemporaryFolder;

constexpr int kWidth = 20, kHeight = 12;

SinkOptions options() {
  SinkOptions result;
  result.size = {kWidth, kHeight};
  return result;
}

void write_frame(FrameSink& sink, int frame, const warp::Image& image) {
  sink.write(frame, sink.encode(frame, image));
}

TEST(FileSink, WritesNumberedFramesInAnyOrder) {
  const TemporaryFolder folder;
  const auto sink = open_sink(folder / "f.%03d.png", options(), false);
  for (const int frame : {7, 2, 5}) {
    EXPECT_FALSE(sink->has(frame));
    FrameSink::Packet packet = sink->encode(frame, moving_picture({kWidth, kHeight}, frame));
    EXPECT_FALSE(sink->has(frame)) << "there, but not written yet";
    sink->write(frame, std::move(packet));
    EXPECT_TRUE(sink->has(frame));
  }
  sink->finish();
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"f.002.png", "f.005.png", "f.007.png"}));
  EXPECT_EQ(sink->existing({1, 2, 3, 7}), (std::vector<fs::path>{folder / "f.002.png", folder / "f.007.png"}));
}

TEST(FileSink, TheFileEqualsThatOfWriteImage) {
  const TemporaryFolder folder;
  const warp::Image image = moving_picture({kWidth, kHeight}, 3, true);
  SinkOptions deep = options();
  deep.image.depth = Depth::k16;
  write_frame(*open_sink(folder / "sink.#.png", deep, false), 1, image);
  write_image(folder / "direct.png", image, deep.image);
  EXPECT_EQ(read_bytes(folder / "sink.1.png"), read_bytes(folder / "direct.png"));
  EXPECT_FALSE(read_bytes(folder / "direct.png").empty());
}

TEST(FileSink, HasFindsOnlyWholeFramesOfTheRightSize) {
  const TemporaryFolder folder;
  const auto sink = open_sink(folder / "f.%d.png", options(), false);
  std::ofstream(folder / "f.1.png").close();
  std::ofstream(folder / "f.2.png") << "this is no picture";
  write_image(folder / "f.3.png", moving_picture({kHeight, kWidth}, 0));
  fs::create_directory(folder / "f.4.png");
  for (int frame = 0; frame <= 4; ++frame) EXPECT_FALSE(sink->has(frame)) << frame;
  EXPECT_EQ(sink->existing({0, 1, 2, 3, 4}).size(), 4U);
  write_image(folder / "f.5.png", moving_picture({kWidth, kHeight}, 0));
  EXPECT_TRUE(sink->has(5));
}

TEST(FileSink, AFrameThatExistsIsRefusedUnlessOverwriting) {
  const TemporaryFolder folder;
  std::ofstream(folder / "f.1.png") << "keep me";
  const warp::Image image = moving_picture({kWidth, kHeight}, 0);
  const Error error = error_of([&] { write_frame(*open_sink(folder / "f.%d.png", options(), false), 1, image); });
  EXPECT_EQ(error.kind(), ErrorKind::kIo);
  EXPECT_NE(std::string(error.what()).find("f.1.png"), std::string::npos);
  EXPECT_EQ(read_bytes(folder / "f.1.png").size(), 7U);
  SinkOptions overwriting = options();
  overwriting.image.overwrite = true;
  const auto sink = open_sink(folder / "f.%d.png", overwriting, false);
  write_frame(*sink, 1, image);
  EXPECT_TRUE(sink->has(1));
}

TEST(FileSink, ASingleFrameTakesAPlainName) {
  const TemporaryFolder folder;
  const auto sink = open_sink(folder / "still.png", options(), true);
  EXPECT_TRUE(sink->existing({12}).empty());
  write_frame(*sink, 12, moving_picture({kWidth, kHeight}, 12));
  EXPECT_TRUE(sink->has(12));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"still.png"});
}

TEST(FileSink, SeveralFramesNeedAPlaceForTheNumber) {
  const TemporaryFolder folder;
  const Error error = error_of([&] { open_sink(folder / "still.png", options(), false); });
  EXPECT_EQ(error.kind(), ErrorKind::kUnsupported);
  EXPECT_NE(error.message().find("still.%04d.png"), std::string::npos) << error.message();
  EXPECT_EQ(error_of([&] { open_sink(folder / "a.%d.%d.png", options(), false); }).kind(), ErrorKind::kUnsupported);
}

TEST(FileSink, AnImageOfAnotherSizeIsABrokenContract) {
  const TemporaryFolder folder;
  const auto sink = open_sink(folder / "f.%d.png", options(), false);
  EXPECT_THROW(sink->encode(0, moving_picture({kWidth + 1, kHeight}, 0)), std::invalid_argument);
  EXPECT_TRUE(folder.names().empty());
}

TEST(OpenSink, AnUnknownKindIsRefusedWithTheChoices) {
  const TemporaryFolder folder;
  for (const char* name : {"out.avi", "out", "out.%04d", "out.%04d.xyz", "out.txt"}) {
    const Error error = error_of([&] { open_sink(folder / name, options(), true); });
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported) << name;
    for (const char* choice : {".mp4", ".webm", ".mkv", ".mov", ".gif", ".apng", "frame.%04d.png"})
      EXPECT_NE(error.message().find(choice), std::string::npos) << error.message();
  }
  const Error numbered = error_of([&] { open_sink(folder / "out.%04d.mp4", options(), false); });
  EXPECT_EQ(numbered.kind(), ErrorKind::kUnsupported);
  EXPECT_NE(numbered.message().find("one file"), std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

TEST(OpenSink, RefusesOptionsThatTheKindDoesNotSupport) {
  const TemporaryFolder folder;
  const auto refusal = [&](const char* name, const std::string& preset, int compression) {
    SinkOptions how = options();
    how.preset = preset;
    how.image.compression = compression;
    const Error error = error_of([&] { open_sink(folder / name, how, false); });
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported) << name;
    EXPECT_EQ(error.place(), (folder / name).string());
    return error.message();
  };
  EXPECT_NE(refusal("f.%d.png", "fast", -1).find("for .mp4 and .webm"), std::string::npos);
  EXPECT_NE(refusal("o.mkv", "fast", -1).find("for .mp4 and .webm"), std::string::npos);
  EXPECT_NE(refusal("o.mp4", "good", -1).find("veryfast, ultrafast"), std::string::npos);
  EXPECT_NE(refusal("o.webm", "veryfast", -1).find("realtime, good, best"), std::string::npos);
  EXPECT_NE(refusal("o.mp4", "", 3).find("no levels of compression"), std::string::npos);
  EXPECT_NE(refusal("o.apng", "", 10).find("0 (none) to 9"), std::string::npos);
  EXPECT_NE(refusal("f.%d.jpg", "", 3).find("JPEG has no levels"), std::string::npos);
  EXPECT_NE(refusal("f.%d.webp", "", 3).find("WebP has no levels"), std::string::npos);
  EXPECT_NE(refusal("f.%d.png", "", 10).find("0 (none) to 9"), std::string::npos);
  SinkOptions half = options();
  half.image.depth = Depth::kHalf;
  EXPECT_EQ(error_of([&] { open_sink(folder / "f.%d.png", half, false); }).kind(), ErrorKind::kUnsupported);
  EXPECT_TRUE(folder.names().empty());
}

TEST(OpenSink, AMissingFolderIsNamed) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  for (const char* name : {"none/f.%d.png", "none/still.png", "none/out.mp4", "file/f.%d.png", "file/out.mp4"}) {
    const Error error = error_of([&] { open_sink(folder / name, options(), true); });
    EXPECT_EQ(error.kind(), ErrorKind::kIo) << name;
    EXPECT_NE(std::string(error.what()).find((folder / name).parent_path().string()), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
}

TEST(OpenSink, AFolderThatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  const fs::path locked = folder / "locked";
  fs::create_directory(locked);
  fs::permissions(locked,
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  // Root may write anywhere: test as another user.
  constexpr uid_t kNobody = 65534;
  const bool root = ::geteuid() == 0;
  ASSERT_EQ(root ? ::seteuid(kNobody) : 0, 0);
  for (const char* name : {"f.%d.png", "out.mp4"}) {
    const Error error = error_of([&] { open_sink(locked / name, options(), false); });
    EXPECT_EQ(error.kind(), ErrorKind::kIo) << name;
    EXPECT_NE(std::string(error.what()).find(locked.string()), std::string::npos) << error.what();
  }
  ASSERT_EQ(root ? ::seteuid(0) : 0, 0);
}

}  // namespace
}  // namespace morphkit::media
