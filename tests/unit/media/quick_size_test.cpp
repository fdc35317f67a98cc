#include "morph/media/quick_size.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::media {
namespace {

using test::TemporaryFolder;

/// A PNG file of header, pixels and end alone.
test::Bytes without_texts(const test::Bytes& bytes) {
  test::Bytes plain(bytes.begin(), bytes.begin() + 8);
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = 12 + (std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 |
                                   std::size_t{bytes[at + 2]} << 8 | bytes[at + 3]);
    const std::string type(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                           bytes.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    if (type == "IHDR" || type == "IDAT" || type == "IEND")
      plain.insert(plain.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  }
  return plain;
}

TEST(QuickSize, IsThatOfReadInfoForPlainPngFiles) {
  const TemporaryFolder folder;
  for (const Depth depth : {Depth::k8, Depth::k16}) {
    WriteOptions options;
    options.depth = depth;
    options.overwrite = true;
    write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}), options);
    test::write_bytes(folder / "a.png", without_texts(test::read_bytes(folder / "a.png")));
    const auto size = quick_size(folder / "a.png");
    ASSERT_TRUE(size.has_value());
    const ImageInfo info = read_info(folder / "a.png");
    EXPECT_EQ(*size, cv::Size(info.width, info.height));
  }
}

TEST(QuickSize, LeavesOtherFormatsToTheLibrary) {
  const TemporaryFolder folder;
  for (const char* name : {"a.jpg", "a.tif", "a.exr", "a.webp"}) {
    write_image(folder / name, warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
    EXPECT_FALSE(quick_size(folder / name).has_value()) << name;
  }
}

/// A text may say which way is up, so it is the library's.
TEST(QuickSize, LeavesPngFilesWithTextsToTheLibrary) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  test::Bytes bytes = test::read_bytes(folder / "a.png");
  const test::Bytes text = {0, 0, 0, 0, 'e', 'X', 'I', 'f', 0, 0, 0, 0};
  const std::ptrdiff_t after_header = 8 + 25;
  bytes.insert(bytes.begin() + after_header, text.begin(), text.end());
  const std::uint32_t checksum = 0xCA79'9704;  // CRC-32 of "eXIf"
  for (int i = 0; i < 4; ++i)
    bytes[static_cast<std::size_t>(after_header + 8 + i)] = static_cast<std::uint8_t>(checksum >> (24 - 8 * i));
  test::write_bytes(folder / "a.png", bytes);
  EXPECT_FALSE(quick_size(folder / "a.png").has_value());
}

TEST(QuickSize, RefusesWhatReadInfoRefuses) {
  const TemporaryFolder folder;
  EXPECT_THROW(quick_size(folder / "missing.png"), Error);
  write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  test::Bytes bytes = test::read_bytes(folder / "a.png");
  bytes.resize(bytes.size() - 20);
  test::write_bytes(folder / "a.png", bytes);
  EXPECT_THROW(quick_size(folder / "a.png"), Error);
}

}  // namespace
}  // namespace morphkit::media
