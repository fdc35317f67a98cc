// Tests cli/cmd_info.cpp, cli/run_info.cpp, cli/picture_info.cpp and cli/project_info.cpp.

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/commands.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

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

/// 8000 x 8000 pixels of one bit, a file of a few kB; as linear floats they take 1 GB.
Bytes large_png() {
  constexpr std::uint32_t kSize = 8000;
  constexpr std::size_t kRow = 1 + kSize / 8;
  const auto number = [](std::uint32_t value) {
    return Bytes{static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
                 static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
  };
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  const auto add_chunk = [&](const std::string& name, const Bytes& data) {
    Bytes named(name.begin(), name.end());
    named.insert(named.end(), data.begin(), data.end());
    const auto sum = static_cast<std::uint32_t>(crc32(0, named.data(), static_cast<uInt>(named.size())));
    for (const Bytes& part : {number(static_cast<std::uint32_t>(data.size())), named, number(sum)})
      file.insert(file.end(), part.begin(), part.end());
  };
  Bytes header = number(kSize);
  for (const std::uint8_t byte : number(kSize)) header.push_back(byte);
  header.insert(header.end(), {1, 0, 0, 0, 0});
  const Bytes rows(kRow * kSize, 0);
  Bytes packed(compressBound(rows.size()));
  uLongf size = packed.size();
  compress(packed.data(), &size, rows.data(), rows.size());
  packed.resize(size);
  add_chunk("IHDR", header);
  add_chunk("IDAT", packed);
  add_chunk("IEND", {});
  return file;
}

TEST(Info, APictureThatNeedsMoreMemoryThanThereIsIsNotCalledDamaged) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs more address space than the limit";
#endif
  TemporaryFolder folder;
  write_bytes(folder / "large.png", large_png());
  const std::vector<std::string> arguments = {
      "--as=1200000000", morphkit_program().string(), "info", "--pixels", "-j", "1", (folder / "large.png").string()};
  const RunResult result = run_program("/usr/bin/prlimit", arguments);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_TRUE(contains(result.err, "large.png: not enough memory for 8000 x 8000 pixels (1.0 GB)")) << result.err;
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

}  // namespace
}  // namespace morphkit::test
